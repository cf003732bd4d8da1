#include <pybind11/numpy.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "conoid/tracing/footprint.h"
#include "conoid/tracing/spectacle_conoid.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/specs/ellipse_query.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"
#include "python/bindings.h"
#include "python/eye_objects.h"
#include "python/json_objects.h"
#include "stages/ellipse_stage.h"

namespace sturm {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();  // as NumPy and pandas have it

/// An element of the array that Python gets; the keys are those of sturm.ellipse_result/1.
struct EllipseRow {
  double accommodation_D = missing;
  double semi_major_rad = missing, semi_minor_rad = missing, semi_major_m = missing, semi_minor_m = missing;
  double orientation_deg = missing;
  double angular_xx = missing, angular_xy = missing, angular_yx = missing, angular_yy = missing;
  std::uint8_t status = 0;
};

/// Numbers for the targets: one for each, or one for all.
class PerTarget {
 public:
  using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
  PerTarget(const Array& array, const char* name, double least, double most, const char* expected)
      : values_(array.data()), step_(array.size() == 1 ? 0 : 1) {
    for (py::ssize_t i = 0; i < array.size(); ++i)
      if (!(values_[i] >= least && values_[i] <= most))
        throw InputError("", name, std::isfinite(values_[i]) ? exact_number(values_[i]) : "NaN or infinity", expected);
  }
  double operator[](std::size_t i) const { return values_[i * step_]; }

 private:
  const double* values_;
  std::size_t step_;
};

struct Targets {
  PerTarget distance_m, azimuth_deg, elevation_deg;

  Eigen::Vector3d gaze(std::size_t i) const {
    return gaze_direction(radians_per_degree * azimuth_deg[i], radians_per_degree * elevation_deg[i]);
  }
  bool same_gaze(std::size_t i, std::size_t k) const {
    return azimuth_deg[i] == azimuth_deg[k] && elevation_deg[i] == elevation_deg[k];
  }
};

EllipseRow row_of(const Footprint& footprint, double pupil_radius_m) {
  const Ellipse ellipse = Ellipse::image_of_disc(footprint.angular, pupil_radius_m);
  EllipseRow row;
  row.accommodation_D = footprint.accommodation_D;
  row.semi_major_rad = ellipse.semi_major;
  row.semi_minor_rad = ellipse.semi_minor;
  if (std::isfinite(footprint.distance_m)) {
    row.semi_major_m = footprint.distance_m * ellipse.semi_major;
    row.semi_minor_m = footprint.distance_m * ellipse.semi_minor;
  }
  if (ellipse.orientation_deg) row.orientation_deg = *ellipse.orientation_deg;
  row.angular_xx = footprint.angular(0, 0);
  row.angular_xy = footprint.angular(0, 1);
  row.angular_yx = footprint.angular(1, 0);
  row.angular_yy = footprint.angular(1, 1);
  return row;
}

void naked_rows(const Eye& eye, const Targets& targets, std::size_t first, std::size_t last, EllipseRow* rows) {
  for (std::size_t i = first; i < last; ++i)
    rows[i] = row_of(naked_eye_footprint(eye, targets.distance_m[i]), eye.pupil_radius_m);
}

/// Targets that follow each other in one direction share their conoid.
void worn_rows(const Eye& eye, const Spectacles& lens, const Targets& targets, std::size_t first, std::size_t last,
               EllipseRow* rows) {
  SpectacleConoid conoid;
  for (std::size_t i = first; i < last; ++i) {
    if (i == first || !targets.same_gaze(i, i - 1)) conoid = trace_conoid(lens, targets.gaze(i), eye.rotation_center_m);
    rows[i] = EllipseRow{};
    if (conoid.status == LensStatus::ok) {
      const double distance_m = targets.distance_m[i];
      rows[i] = row_of(
          spectacle_footprint(conoid, eye, distance_m, accommodation_through(conoid, eye, vergence_of(distance_m))),
          eye.pupil_radius_m);
    }
    rows[i].status = static_cast<std::uint8_t>(conoid.status);
  }
}

py::array_t<EllipseRow> rows_of(const EyeObject& wearer, const PerTarget::Array& distance_m,
                                const PerTarget::Array& azimuth_deg, const PerTarget::Array& elevation_deg,
                                const SpectaclesObject* spectacles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr const char* angle = "angles of -89 to 89 [deg]";
  const Targets targets{{distance_m, "distance_m", 1e-6, infinity, "distances of at least 1e-6, or infinity [m]"},
                        {azimuth_deg, "azimuth_deg", -89.0, 89.0, angle},
                        {elevation_deg, "elevation_deg", -89.0, 89.0, angle}};
  py::ssize_t count = 1;
  for (const PerTarget::Array* array : {&distance_m, &azimuth_deg, &elevation_deg})
    if (array->size() != 1) count = array->size();
  for (const PerTarget::Array* array : {&distance_m, &azimuth_deg, &elevation_deg})
    if (array->size() != 1 && array->size() != count)
      throw InputError("", "distance_m, azimuth_deg, elevation_deg", std::to_string(array->size()) + " numbers",
                       "one number, or as many as the others have: " + std::to_string(count));
  py::array_t<EllipseRow> array(count);
  EllipseRow* rows = array.mutable_data();
  const py::gil_scoped_release release;
  constexpr std::size_t block = 1024;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, static_cast<std::size_t>(count), block),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      if (spectacles)
                        worn_rows(wearer.eye, *spectacles->spec.lens, targets, range.begin(), range.end(), rows);
                      else
                        naked_rows(wearer.eye, targets, range.begin(), range.end(), rows);
                    });
  return array;
}

py::object answer(const py::object& query, const std::string& file) {
  const GivenDocument given = given_document(query, file);
  Json result;
  {
    const py::gil_scoped_release release;
    result = blur_ellipses(read_ellipse_query(given.document, given.file));
  }
  return object_from(result);
}

}  // namespace

void bind_ellipses(py::module_& module) {
  using namespace pybind11::literals;
  PYBIND11_NUMPY_DTYPE(EllipseRow, accommodation_D, semi_major_rad, semi_minor_rad, semi_major_m, semi_minor_m,
                       orientation_deg, angular_xx, angular_xy, angular_yx, angular_yy, status);
  py::list words;
  for (const std::string& word : lens_status_words.all()) words.append(word);
  module.attr("lens_status_words") = py::tuple(words);
  module.def("ellipse_rows", &rows_of, "eye"_a, "distance_m"_a, "azimuth_deg"_a, "elevation_deg"_a,
             "spectacles"_a.none(true),
             "Blur ellipses by conoid tracing, one for each target; arrays of one number hold for all targets.");
  module.def("ellipse", &answer, "query"_a, "file"_a = "",
             "Answers a query of format sturm.ellipse/1 by every method that it names: sturm.ellipse_result/1.");
}

}  // namespace sturm
