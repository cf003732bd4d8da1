#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "io/json/schema.h"
#include "io/specs/spectacles_spec.h"
#include "lensmodel/units.h"
#include "python/bindings.h"
#include "python/eye_objects.h"
#include "python/json_objects.h"
#include "stages/lens_stage.h"

namespace sturm {

namespace {

SpectaclesObject spectacles_from(const py::object& given, const EyeObject* wearer, const std::string& file) {
  const Source where{file.empty() ? python_document : file, ""};
  const Json document = json_from(given, where);
  if (document.is_object()) validate(document, "spectacles", where.file);
  if (document.is_null()) where.fail(document, "a lens");
  return {wearer ? read_spectacles(document, where, wearer->eye) : read_lens_alone(document, where)};
}

py::object report_of(const SpectaclesObject& object, std::vector<double> azimuths_deg,
                     std::vector<double> elevations_deg, double rotation_center_mm) {
  for (const std::vector<double>* angles : {&azimuths_deg, &elevations_deg})
    for (const double angle : *angles)
      if (!(angle >= -89.0 && angle <= 89.0))
        Source{python_document, ""}.fail(Json(angle), "an angle of -89 to 89 [deg]");
  const LensQuery query{*object.spec.lens,       object.spec.material,
                        object.spec.fits,        metres_per_millimetre * rotation_center_mm,
                        std::move(azimuths_deg), std::move(elevations_deg)};
  Json result;
  {
    const py::gil_scoped_release release;
    result = lens_report(query);
  }
  return object_from(result);
}

}  // namespace

void bind_lenses(py::module_& module) {
  using namespace pybind11::literals;
  py::class_<SpectaclesObject>(module, "Spectacles", "A thick spectacle lens before one eye. It does not change.")
      .def(py::init(&spectacles_from), "document"_a, "wearer"_a.none(true) = nullptr, "file"_a = "")
      .def_property_readonly(
          "center_thickness_mm",
          [](const SpectaclesObject& o) { return o.spec.lens->center_thickness_m / metres_per_millimetre; },
          "Thickness in the middle [mm].")
      .def_property_readonly(
          "refractive_index", [](const SpectaclesObject& o) { return o.spec.lens->refractive_index; }, "At 587.6 nm.")
      .def_property_readonly(
          "vertex_distance_mm",
          [](const SpectaclesObject& o) { return o.spec.lens->vertex_distance_m / metres_per_millimetre; },
          "From the back vertex to the plane of the pupil [mm].")
      .def_property_readonly(
          "diameter_mm", [](const SpectaclesObject& o) { return o.spec.lens->diameter_m / metres_per_millimetre; },
          "Of the rim [mm].")
      .def_property_readonly(
          "notes", [](const SpectaclesObject& o) { return o.spec.notes; },
          "What is remarkable about the lens, in words.")
      .def("report", &report_of, "azimuths_deg"_a, "elevations_deg"_a,
           "rotation_center_mm"_a = 1e3 * mean_rotation_center_m,
           "What `sturm lens` says of the lens (sturm.lens_report/1): powers as worn for all pairs of azimuth (to the\n"
           "wearer's right) and elevation (up) [deg], prism, thickness.");
}

}  // namespace sturm
