#pragma once
#include <optional>

#include "io/json/json.h"
#include "lensmodel/zernike_wave.h"

namespace sturm {

/// A wavefront as an eye's document states it.
struct WavefrontSpec {
  ZernikeWave wave;  ///< wearer frame
  SecondOrder second_order = SecondOrder::LeastSquares;
  bool combine = false;                 ///< with the eye's prescription
  std::optional<double> wavelength_nm;  ///< of the light it was measured with, or stated for
};

/// Reads an eye's "wavefront", its defaults filled in: any order, normalised or not, mirrored on request. Throws
/// InputError.
WavefrontSpec read_wavefront(const Json& value, const Source& where);

/// The wavelength [nm] that the wavefront of an eye (object or path) is stated for; none where it has none.
std::optional<double> stated_wavelength_nm(const Json& eye, const Source& where);

}  // namespace sturm
