#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "python/bindings.h"
#include "python/json_objects.h"
#include "stages/blur_field_stage.h"

namespace sturm {

namespace {

/// The class BlurField of Python.
using FieldHolder = std::unique_ptr<BlurField>;

FieldHolder field_from(const py::object& document, const std::string& file) {
  const GivenDocument given = given_document(document, file);
  const py::gil_scoped_release release;
  return std::make_unique<BlurField>(compute_blur_field(read_blur_field_spec(given.document, given.file)));
}

/// An array that looks into the memory of `owner` and may not be written.
template <class Number>
py::array looking_into(const py::object& owner, std::vector<py::ssize_t> shape, const Number* numbers) {
  py::array_t<Number> array(std::move(shape), numbers, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::object nodes_of(const py::object& self) {
  const auto& field = self.cast<const BlurField&>();
  if (!field.analytic) return py::none();
  return looking_into(self, {field.grid.ny, field.grid.nx, 4, 2, 2}, field.analytic->nodes().data()->a);
}

py::object usable_of(const py::object& self) {
  const auto& field = self.cast<const BlurField&>();
  if (!field.analytic) return py::none();
  return looking_into(self, {field.grid.ny, field.grid.nx}, field.analytic->usable().data());
}

py::object voxels_of(const py::object& self) {
  const auto& field = self.cast<const BlurField&>();
  if (!field.voxels) return py::none();
  if (field.voxels->sparse())
    throw InputError("", "voxels", "a field that stores visible voxels alone", "a field of all voxels");
  return looking_into(self, {field.grid.ny, field.grid.nx, field.grid.nz, 2, 2}, field.voxels->column(0));
}

py::array_t<double> vergences_of(const BlurField& field) {
  py::array_t<double> vergences(field.grid.nz);
  for (int k = 0; k < field.grid.nz; ++k) vergences.mutable_at(k) = field.grid.vergence(k);
  return vergences;
}

py::object footprint_of(const BlurField& field, float x, float y, float vergence_D, float accommodation_D) {
  if (!field.analytic) throw InputError("", "footprint", "a field without nodes", "a field with depth_analytic");
  const auto footprint = field.analytic->angular_footprint(x, y, vergence_D, accommodation_D);
  return footprint ? py::cast(*footprint) : py::none();
}

}  // namespace

void bind_blur_fields(py::module_& module) {
  using namespace pybind11::literals;
  py::class_<BlurField>(
      module, "BlurField",
      "The blur of all lines of sight of a field of view at all distances. It does not change; its arrays look\n"
      "into its memory, single precision.")
      .def(py::init(&field_from), "document"_a, "file"_a = "")
      .def_property_readonly(
          "nodes", &nodes_of,
          "Array (ny, nx, 4, 2, 2) of A, B, Q0 and Q1 for each line of sight, row 0 at the top: the map of the\n"
          "pupil is V A + B - a (V Q0 + Q1) [rad/m] at the vergence V [D] and the accommodation a [D].\n"
          "None where the document leaves it out.")
      .def_property_readonly("usable", &usable_of,
                             "Array (ny, nx): 1 where a line of sight has a conoid. None as for nodes.")
      .def_property_readonly(
          "voxels", &voxels_of,
          "Array (ny, nx, nz, 2, 2) of maps of the pupil [rad/m]; 0 where there is none. None where the document\n"
          "leaves it out.")
      .def_property_readonly("vergences_D", &vergences_of, "1/distance [D] of the nz slices, nearest first.")
      .def_property_readonly(
          "summary", [](const BlurField& f) { return object_from(f.summary); },
          "What `sturm blurfield` prints: sizes, counters, the error of interpolation.")
      .def("footprint", &footprint_of, "x"_a, "y"_a, "vergence_D"_a, "accommodation_D"_a = 0.0f,
           "The map of the pupil [rad/m] at a place of the field (x and y from -1 to 1, right and up) and a vergence "
           "[D];\n"
           "None where there is none.");
}

}  // namespace sturm
