#include "experiments/run/wrong_eyes.h"

#include "lensmodel/zernike_order.h"

namespace sturm {

namespace {

/// As an examiner writes them.
std::vector<double> written(const ZernikeWave& wave) {
  return mirrored(wave.coefficients());
}

/// Of `read(coefficients, radius)`, which gives the wave that is taken for the eye's own.
template <class Read>
Eye with_wave(Eye eye, const Read& read) {
  if (eye.wavefront) eye.wavefront = read(written(*eye.wavefront), eye.wavefront->radius_m());
  return eye;
}

}  // namespace

Eye mirrored_eye(const Eye& eye) {
  return with_wave(eye, [](const std::vector<double>& coefficients, double radius_m) {
    return ZernikeWave::from_examiner(mirrored(coefficients), radius_m);
  });
}

Eye point_reflected_eye(const Eye& eye) {
  return with_wave(eye, [](std::vector<double> coefficients, double radius_m) {
    for (std::size_t j = 0; j < coefficients.size(); ++j)
      if (zernike_index(ZernikeOrder::Osa, static_cast<int>(j)).n % 2 == 1) coefficients[j] = -coefficients[j];
    return ZernikeWave::from_examiner(coefficients, radius_m);
  });
}

Eye eye_read_as_noll(const Eye& eye) {
  return with_wave(eye, [](std::vector<double> coefficients, double radius_m) {
    coefficients.erase(coefficients.begin());  // Noll has no number 0
    return ZernikeWave::from_examiner(osa_coefficients(coefficients, ZernikeOrder::Noll, true), radius_m);
  });
}

Eye eye_of_wrong_pupil(const Eye& eye) {
  return with_wave(eye, [&](const std::vector<double>& coefficients, double) {
    return ZernikeWave::from_examiner(coefficients, eye.pupil_radius_m);
  });
}

Eye eye_without_stiles_crawford(const Eye& eye) {
  Eye uniform = eye;
  uniform.stiles_crawford_per_m2 = 0.0;
  return uniform;
}

}  // namespace sturm
