#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "lensmodel/units.h"
#include "python/bindings.h"
#include "python/eye_objects.h"
#include "python/json_objects.h"

namespace sturm {

namespace {

EyeObject eye_from(const py::object& given, const std::string& file) {
  const GivenDocument eye = given_document(given, file);
  validate(eye.document, "eye", eye.file);
  EyeSpec spec = read_eye_spec(eye.document, {eye.file, ""});
  return {std::move(spec.eye), std::move(spec.notes)};
}

py::dict dictionary_with_vertex(const Prescription& rx) {
  py::dict result = dictionary_of(rx);
  result["vertex_distance_mm"] = rx.vertex_distance_m / metres_per_millimetre;
  return result;
}

py::dict power_vector_of(const EyeObject& object) {
  py::dict result;
  add_power_vector(result, object.eye.correction.as_prescription());
  return result;
}

}  // namespace

py::dict dictionary_of(const Prescription& rx) {
  py::dict result;
  result["sphere_D"] = rx.sphere_D;
  result["cylinder_D"] = rx.cylinder_D;
  result["axis_deg"] = rx.axis_deg;
  return result;
}

void add_power_vector(py::dict& dictionary, const Prescription& rx) {
  const PowerVector vector = power_vector(rx);
  dictionary["M_D"] = vector.M;
  dictionary["J0_D"] = vector.J0;
  dictionary["J45_D"] = vector.J45;
}

void bind_eyes(py::module_& module) {
  using namespace pybind11::literals;
  py::class_<EyeObject>(module, "Eye", "An eye: its correction, its pupil and how it accommodates. It does not change.")
      .def(py::init(&eye_from), "document"_a, "file"_a = "")
      .def_property_readonly(
          "prescription", [](const EyeObject& o) { return dictionary_with_vertex(o.eye.prescription); },
          "As it was written: sphere_D, cylinder_D, axis_deg (TABO), vertex_distance_mm.")
      .def_property_readonly(
          "at_cornea", [](const EyeObject& o) { return dictionary_with_vertex(o.eye.correction.as_prescription()); },
          "The same correction at the cornea, in minus-cylinder form.")
      .def_property_readonly("power_vector", &power_vector_of,
                             "M_D, J0_D and J45_D of the correction at the cornea [D], examiner's frame.")
      .def_property_readonly(
          "correction_D", [](const EyeObject& o) { return Eigen::Matrix2d(o.eye.correction.matrix()); },
          "The correcting power at the cornea as a symmetric matrix [D], wearer's frame (x right, y up).")
      .def_property_readonly(
          "pupil_diameter_mm", [](const EyeObject& o) { return 2.0 * o.eye.pupil_radius_m / metres_per_millimetre; },
          "Diameter of the pupil [mm].")
      .def_property_readonly(
          "rotation_center_mm", [](const EyeObject& o) { return o.eye.rotation_center_m / metres_per_millimetre; },
          "Distance of the centre of rotation behind the pupil [mm].")
      .def_readonly("notes", &EyeObject::notes, "What is remarkable about the eye, in words.")
      .def(
          "accommodation_for_D",
          [](const EyeObject& o, double distance_m) { return o.eye.accommodation_for(vergence_of(distance_m)); },
          "distance_m"_a, "The accommodation [D] for a target at this distance [m], without spectacles.");
}

}  // namespace sturm
