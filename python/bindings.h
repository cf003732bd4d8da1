#pragma once
#include <pybind11/pybind11.h>

namespace sturm {

namespace py = pybind11;

// What the module _core has, one file each.
void bind_errors(py::module_& module);
void bind_documents(py::module_& module);
void bind_prescriptions(py::module_& module);
void bind_eyes(py::module_& module);
void bind_lenses(py::module_& module);
void bind_ellipses(py::module_& module);
void bind_wavefronts(py::module_& module);
void bind_point_spreads(py::module_& module);
void bind_blur_fields(py::module_& module);
void bind_pictures(py::module_& module);
void bind_seen_pictures(py::module_& module);
void bind_metrics(py::module_& module);
void bind_gates(py::module_& module);

}  // namespace sturm
