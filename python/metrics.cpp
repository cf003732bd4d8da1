#include <pybind11/stl.h>

#include "compare/images/picture_comparison.h"
#include "io/files/error.h"
#include "python/arrays.h"
#include "python/bindings.h"

namespace sturm {

namespace {

py::dict values_of(const PictureComparison& comparison) {
  py::dict values;
  for (const ImageMetric& metric : comparison.metrics) values[py::str(metric.key)] = metric.value;
  return values;
}

py::dict maps_of(PictureComparison& comparison) {
  py::dict maps;
  for (ImageMetric& metric : comparison.metrics)
    if (!metric.map.pixels.empty()) maps[py::str(metric.key)] = array_of(std::move(metric.map));
  return maps;
}

py::tuple compared(const py::object& test, const py::object& reference, double exposure,
                   const std::optional<double>& pixels_per_degree) {
  const Image first = image_of(test, "test", 3), second = image_of(reference, "reference", 3);
  ImageMetricSettings settings;
  if (!(exposure > 0.0)) throw InputError("", "exposure", std::to_string(exposure), "a number > 0");
  settings.exposure = exposure;
  if (pixels_per_degree) {
    if (!(*pixels_per_degree > 0.0))
      throw InputError("", "pixels_per_degree", std::to_string(*pixels_per_degree), "a number > 0");
    settings.pixels_per_degree = *pixels_per_degree;
  }
  PictureComparison comparison;
  {
    const py::gil_scoped_release release;
    comparison = compare_pictures(first, second, {}, settings);
  }
  const py::dict values = values_of(comparison);
  return py::make_tuple(values, maps_of(comparison));
}

}  // namespace

void bind_metrics(py::module_& module) {
  using namespace pybind11::literals;
  module.def(
      "compare_pictures", &compared, "test"_a, "reference"_a, "exposure"_a = 1.0, "pixels_per_degree"_a = py::none(),
      "All metrics of `sturm compare` of two pictures in linear light, by their keys, and the local values of those\n"
      "that have some.");
  py::dict titles;
  for (const ImageMetricName& name : image_metric_names()) titles[name.key] = py::str(name.title);
  module.attr("metric_titles") = titles;
}

}  // namespace sturm
