#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "lensmodel/units.h"
#include "lensmodel/zernike_order.h"
#include "lensmodel/zernike_wave.h"
#include "python/bindings.h"
#include "python/eye_objects.h"
#include "python/json_objects.h"
#include "stages/wavefront_stage.h"

namespace sturm {

namespace {

constexpr double radius_m(double diameter_mm) {
  return 0.5 * metres_per_millimetre * diameter_mm;
}

ZernikeWave wave_from(const std::vector<double>& coefficients_um, double pupil_diameter_mm) {
  std::vector<double> coefficients_m;
  for (const double c : coefficients_um) {
    if (!std::isfinite(c)) throw InputError("", "coefficients_um", "NaN or infinity", "finite numbers [um]");
    coefficients_m.push_back(metres_per_micrometre * c);
  }
  return ZernikeWave::from_examiner(coefficients_m, radius_m(pupil_diameter_mm));
}

py::array_t<double> coefficients_um(const ZernikeWave& wave) {
  std::vector<double> examiner = mirrored(wave.coefficients());
  for (double& c : examiner) c /= metres_per_micrometre;
  return py::array_t<double>(static_cast<py::ssize_t>(examiner.size()), examiner.data());
}

py::dict power_of(const ZernikeWave& wave, const std::string& rule) {
  const auto known = second_order_words.value_of(rule);
  if (!known) throw InputError("", "rule", "\"" + rule + "\"", "\"least_squares\" or \"paraxial\"");
  const Prescription rx = wave.power(*known).as_prescription();
  py::dict result = dictionary_of(rx);
  add_power_vector(result, rx);
  return result;
}

double height_um(const ZernikeWave& wave, double x_mm, double y_mm) {
  return wave.height({metres_per_millimetre * x_mm, metres_per_millimetre * y_mm}) / metres_per_micrometre;
}

py::object wavefront_of(const EyeObject& object) {
  return object.eye.wavefront ? py::cast(*object.eye.wavefront) : py::none();
}

}  // namespace

void bind_wavefronts(py::module_& module) {
  using namespace pybind11::literals;
  py::class_<ZernikeWave>(
      module, "Wavefront",
      "A wavefront over a pupil as Zernike coefficients (OSA/ANSI order, normalised). It does not change.")
      .def(py::init(&wave_from), "coefficients_um"_a, "pupil_diameter_mm"_a,
           "Coefficients [um] from j = 0 on, examiner's frame, for a pupil of this diameter [mm].")
      .def_property_readonly("coefficients_um", &coefficients_um, "Coefficients [um] from j = 0 on, examiner's frame.")
      .def_property_readonly(
          "pupil_diameter_mm", [](const ZernikeWave& w) { return 2.0 * w.radius_m() / metres_per_millimetre; },
          "Diameter that the coefficients are stated for [mm].")
      .def(
          "rescaled", [](const ZernikeWave& w, double diameter_mm) { return w.rescaled(radius_m(diameter_mm)); },
          "pupil_diameter_mm"_a, "The same wave over a smaller pupil [mm]; exact.")
      .def("power", &power_of, "rule"_a = "least_squares",
           "Correcting power of second order: sphere_D, cylinder_D, axis_deg, M_D, J0_D, J45_D; by \"least_squares\" "
           "over\n"
           "the pupil, or \"paraxial\" at its centre.")
      .def(
          "height_um",
          [](const py::object& self, const py::array_t<double>& x_mm, const py::array_t<double>& y_mm) {
            const ZernikeWave& wave = self.cast<const ZernikeWave&>();
            return py::vectorize([&wave](double x, double y) { return height_um(wave, x, y); })(x_mm, y_mm);
          },
          "x_mm"_a, "y_mm"_a,
          "Height of the wave [um] at points of the pupil [mm], wearer's frame (x right, y up); x and y broadcast.");
  module.def("eye_wavefront", &wavefront_of, "eye"_a,
             "The wavefront of an eye over the pupil that it was measured for, or None.");
  module.def(
      "refraction",
      [](const std::vector<double>& coefficients, double pupil_mm) {
        return object_from(refraction_json(coefficients, pupil_mm));
      },
      "coefficients_um"_a, "pupil_diameter_mm"_a,
      "Power and higher orders of OSA coefficients [um], as `sturm wavefront` reports them.");
}

}  // namespace sturm
