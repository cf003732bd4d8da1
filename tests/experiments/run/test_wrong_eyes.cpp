// Eyes that a measured one may be taken for by mistake: each is wrong in just the way that its name says.
#include <gtest/gtest.h>

#include "experiments/run/wrong_eyes.h"
#include "lensmodel/zernike_wave.h"

namespace sturm {
namespace {

using Eigen::Vector2d;

constexpr double um = 1e-6;

/// Of a pupil of 5 mm within a measured one of 6 mm. All terms up to order 3 beyond tilt, and one of order 4.
Eye comatic_eye() {
  const std::vector<double> coefficients = {0.0,      0.0,       0.0,       0.2 * um, 0.9 * um,  -0.3 * um, 0.1 * um,
                                            0.4 * um, -0.2 * um, 0.15 * um, 0.0,      0.05 * um, 0.12 * um};
  Eye eye = Eye::with(ZernikeWave::from_examiner(coefficients, 3e-3), SecondOrder::LeastSquares, std::nullopt, 5e-3);
  eye.stiles_crawford_per_m2 = 0.05e6;
  return eye;
}

constexpr double x = 1.1e-3, y = -0.7e-3;

TEST(WrongEyes, TheMirroredEyeHasItsSlopesMirrored) {
  const Vector2d honest = comatic_eye().wavefront->slope({-x, y}),
                 mirrored = mirrored_eye(comatic_eye()).wavefront->slope({x, y});
  EXPECT_NEAR(mirrored.x(), -honest.x(), 1e-15);
  EXPECT_NEAR(mirrored.y(), honest.y(), 1e-15);
}

TEST(WrongEyes, ThePointReflectedEyeHasItsSlopesTurnedRound) {
  const Vector2d honest = comatic_eye().wavefront->slope({-x, -y}),
                 reflected = point_reflected_eye(comatic_eye()).wavefront->slope({x, y});
  EXPECT_NEAR(reflected.x(), -honest.x(), 1e-15);
  EXPECT_NEAR(reflected.y(), -honest.y(), 1e-15);
}

TEST(WrongEyes, NollCountsOtherwise) {
  // Noll 1976, table I: 5 and 6 are sine and cosine astigmatism, 7 and 8 the comas, 9 and 10 sine and cosine trefoil,
  // 11 spherical aberration, 12 cosine secondary astigmatism. OSA: 3, 5; 7, 8; 6, 9; 12; 13.
  // Number 3 of OSA is oblique astigmatism; of Noll it is vertical tilt, OSA 1.
  const std::vector<double> expected = {0.0,      0.2 * um,  0.0, -0.3 * um, 0.9 * um, 0.1 * um,  0.15 * um,
                                        0.4 * um, -0.2 * um, 0.0, 0.0,       0.0,      0.05 * um, 0.12 * um};
  const ZernikeWave wave = ZernikeWave::from_examiner(expected, 3e-3);
  const Vector2d wrong = eye_read_as_noll(comatic_eye()).wavefront->slope({x, y});
  EXPECT_NEAR(wrong.x(), wave.slope({x, y}).x(), 1e-15);
  EXPECT_NEAR(wrong.y(), wave.slope({x, y}).y(), 1e-15);
}

TEST(WrongEyes, TheWrongPupilIsTheOneInUse) {
  // W'(p) = W(p · 6/5), so the slopes are 6/5 of those farther out.
  const Vector2d honest = comatic_eye().wavefront->slope(1.2 * Vector2d(x, y)),
                 wrong = eye_of_wrong_pupil(comatic_eye()).wavefront->slope({x, y});
  EXPECT_NEAR(wrong.x(), 1.2 * honest.x(), 1e-15);
  EXPECT_NEAR(wrong.y(), 1.2 * honest.y(), 1e-15);
}

TEST(WrongEyes, TheRestOfTheEyeStays) {
  const Eye uniform = eye_without_stiles_crawford(comatic_eye());
  EXPECT_EQ(uniform.stiles_crawford_per_m2, 0.0);
  EXPECT_EQ(uniform.wavefront->slope({x, y}), comatic_eye().wavefront->slope({x, y}));
  EXPECT_EQ(mirrored_eye(comatic_eye()).stiles_crawford_per_m2, 0.05e6);
  EXPECT_EQ(mirrored_eye(comatic_eye()).pupil_radius_m, 2.5e-3);
  Eye plain = Eye::with(Prescription{.sphere_D = -1.0}, 5e-3);
  EXPECT_FALSE(point_reflected_eye(plain).wavefront.has_value());
}

}  // namespace
}  // namespace sturm
