#pragma once
#include <Eigen/Core>

#include "wavefront/psf/wave_sampling.h"

namespace sturm {

/// The point spread of a wave by diffraction, as its optical transfer function
/// OTF(ν) = ∫ PSF(X) e^(−2πi ν·X) dX on a grid of frequencies. Each wavelength has unit energy over all angles, by the
/// pupil's area; OTF(0) is a little below 1 by what the grid does not hold.
struct WavePsf {
  WaveSampling sampling;  ///< the grid that it was computed on
  int highest;            ///< k of the highest frequency k·frequency_step that passes
  Eigen::MatrixXcd otf;   ///< row highest + ky, column kx ≥ 0; the other half is its conjugate
  double strehl_origin;   ///< PSF(0) over that of the same pupil and light without aberration, also chromatic
  double strehl_peak;     ///< the largest value of the PSF in its place
  Eigen::Vector2d peak;   ///< where that is [rad]
  double reference_peak;  ///< PSF(0) without aberration [1/rad²]

  /// PSF [1/rad²] at an angle X [rad].
  double density(const Eigen::Vector2d& x) const;
};

/// Fourier transforms of the pupil, one for each wavelength; samples at the rim have the area of their cell within the
/// pupil. Same bits for any number of threads.
WavePsf wave_psf(const PupilWave& pupil, const Light& light, double vergence_D, const WaveSampling& sampling);

}  // namespace sturm
