#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "io/specs/prescription_notation.h"
#include "io/specs/prescription_table.h"
#include "lensmodel/prescription.h"
#include "lensmodel/units.h"
#include "python/bindings.h"

namespace sturm {

namespace {

py::dict dictionary_of(const NotedPrescription& rx) {
  py::dict result;
  result["eye"] = rx.eye ? py::object(py::str(*rx.eye == EyeSide::right ? "right" : "left")) : py::none();
  result["sphere_D"] = rx.sphere_D;
  result["cylinder_D"] = rx.cylinder_D;
  result["axis_deg"] = rx.axis_deg;
  result["addition_D"] = rx.addition_D;
  result["vertex_distance_mm"] = rx.vertex_distance_mm;
  result["prism_right_cm_per_m"] = rx.prism_right;
  result["prism_up_cm_per_m"] = rx.prism_up;
  result["prism_nasal_cm_per_m"] = rx.prism_nasal;
  result["notation"] = in_notation(rx);
  return result;
}

py::list parsed(const std::string& text) {
  py::list eyes;
  for (const NotedPrescription& rx : parse_prescription_notation(text)) eyes.append(dictionary_of(rx));
  return eyes;
}

py::list table(const std::filesystem::path& file, double vertex_distance_mm) {
  py::list rows;
  for (const TabledPrescription& row : read_prescription_table(file, metres_per_millimetre * vertex_distance_mm)) {
    py::dict entry;
    entry["id"] = row.id;
    entry["sphere_D"] = row.prescription.sphere_D;
    entry["cylinder_D"] = row.prescription.cylinder_D;
    entry["axis_deg"] = row.prescription.axis_deg;
    entry["vertex_distance_mm"] = row.prescription.vertex_distance_m / metres_per_millimetre;
    rows.append(entry);
  }
  return rows;
}

}  // namespace

void bind_prescriptions(py::module_& module) {
  using namespace pybind11::literals;
  module.def(
      "parse_prescription", &parsed, "text"_a,
      "Reads optical notation such as \"OD -2.00 -1.50 x 30 OS PL\": a dictionary for each eye that is named,\n"
      "with sphere_D, cylinder_D, axis_deg (TABO), addition_D, vertex_distance_mm, prisms [cm/m] and the\n"
      "plainest notation. What a text does not say is None. An ambiguous text is an InputError that says how it\n"
      "could be read.");
  module.def("read_prescription_table", &table, "file"_a, "vertex_distance_mm"_a = 12.0,
             "Reads a CSV of prescriptions: a list of dictionaries with id, sphere_D, cylinder_D, axis_deg (TABO) and\n"
             "vertex_distance_mm, which is the argument's where a row states none.");
}

}  // namespace sturm
