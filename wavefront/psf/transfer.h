#pragma once
#include <complex>

#include "wavefront/psf/pupil_wave.h"

namespace sturm {

/// The optical transfer function of a wave at a frequency ν [cycles/rad], by quadrature over the overlap of the pupil
/// with itself shifted by λν: Σ w_λ/area ∫ A(q − λν/2) A(q + λν/2) e^(2πi (W(q − λν/2) − W(q + λν/2))/λ) dq. It knows
/// no grid. Its modulus is the MTF.
std::complex<double> wave_transfer(const PupilWave& pupil, const Light& light, double vergence_D,
                                   const Eigen::Vector2d& frequency);

/// The same of the pupil without any aberration, in the same light; it depends on |ν| alone.
double unaberrated_transfer(const PupilWave& pupil, const Light& light, double frequency);

}  // namespace sturm
