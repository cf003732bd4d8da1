#pragma once
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/spectacles_spec.h"
#include "lensmodel/eye.h"

namespace sturm {

namespace py = pybind11;

/// The class Eye of Python.
struct EyeObject {
  Eye eye;
  std::vector<std::string> notes;
};

/// sphere_D, cylinder_D and axis_deg (TABO) of a power.
py::dict dictionary_of(const Prescription& rx);

/// Adds M_D, J0_D and J45_D of a power to a dictionary, examiner's frame.
void add_power_vector(py::dict& dictionary, const Prescription& rx);

/// The class Spectacles of Python; `spec.lens` is there.
struct SpectaclesObject {
  SpectaclesSpec spec;
};

}  // namespace sturm
