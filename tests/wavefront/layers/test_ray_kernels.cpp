#include <gtest/gtest.h>

#include <cmath>

#include "wavefront/layers/ray_kernels.h"

namespace sturm {
namespace {

constexpr double kernel_pixel = 4e-4;

struct Moments {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
};

Moments moments(const SpreadKernel& kernel) {
  Moments m;
  for (int dy = -kernel.radius_px; dy <= kernel.radius_px; ++dy)
    for (int dx = -kernel.radius_px; dx <= kernel.radius_px; ++dx) {
      const double w = kernel.weight(dx, dy);
      m.x += w * dx;
      m.y += w * dy;
      m.xx += w * dx * dx;
      m.xy += w * dx * dy;
      m.yy += w * dy * dy;
    }
  return m;
}

TEST(RayKernels, PartsMakeUpTheWholeAndSumToOne) {
  const Eye eye = Eye::with(Prescription{-2.0, 0.0, 0.0, 0.0}, 4e-3);
  const KernelModel whole = ray_kernels(eye, 0.0, kernel_pixel, {1, false}),
                    parts = ray_kernels(eye, 0.0, kernel_pixel, {4, false});
  ASSERT_EQ(parts.parts.size(), 4u);
  const SpreadKernel all = whole.kernel(0.5, 0, 0);
  EXPECT_NEAR(all.sum(), 1.0, 1e-6);
  double weight = 0.0;
  Moments sum;
  for (int part = 0; part < 4; ++part) {
    const SpreadKernel kernel = parts.kernel(0.5, part, 0);
    EXPECT_NEAR(kernel.sum(), 1.0, 1e-6);
    weight += parts.parts[part].weight;
    sum.xx += parts.parts[part].weight * moments(kernel).xx;
  }
  EXPECT_NEAR(weight, 1.0, 1e-12);
  EXPECT_NEAR(sum.xx, moments(all).xx, 0.02 * sum.xx);
}

TEST(RayKernels, VarianceIsThatOfTheBlurDiscAndOfLinearInterpolation) {
  // 1.5 D over 2 mm of radius: 3 mrad = 7.5 px, whose variance is r²/4 along each axis; sharing adds 1/6.
  const SpreadKernel kernel =
      ray_kernels(Eye::with(Prescription{-2.0, 0.0, 0.0, 0.0}, 4e-3), 0.0, kernel_pixel, {}).kernel(0.5, 0, 0);
  EXPECT_NEAR(moments(kernel).xx, 7.5 * 7.5 / 4.0 + 1.0 / 6.0, 0.01);
  EXPECT_NEAR(moments(kernel).xy, 0.0, 0.01);
}

TEST(RayKernels, OfAPupilBelowTheMeasuredOneHaveThePartWithinIt) {
  // 1 µm of Z4 over a radius of 3 mm bends rays by 4√3 c r/a²; the pupil in use ends at r = 1.5 mm.
  const std::vector<double> defocus{0.0, 0.0, 0.0, 0.0, 1e-6};
  const Eye eye = Eye::with(ZernikeWave::from_examiner(defocus, 3e-3), SecondOrder::LeastSquares, std::nullopt, 3e-3);
  const double radius_px = 4.0 * std::sqrt(3.0) * 1e-6 * 1.5e-3 / 9e-6 / 1e-4;  // 11.5
  EXPECT_NEAR(moments(ray_kernels(eye, 0.0, 1e-4, {}).kernel(0.0, 0, 0)).xx, radius_px * radius_px / 4.0 + 1.0 / 6.0,
              0.03);
}

TEST(RayKernels, AxisThirtyTurnsTheOtherWayThanAxisOneHundredAndFifty) {
  const auto covariance = [](double axis) {
    return moments(ray_kernels(Eye::with(Prescription{0.0, -2.0, axis, 0.0}, 4e-3), 0.0, kernel_pixel, {})
                       .kernel(0.0, 0, 0))
        .xy;
  };
  // AXIS 30 is the meridian 150° of the wearer; power acts across it, along 60°: up and to the right, where rows go
  // down, so that right and down vary against each other. C a = 4 mrad = 10 px along it.
  EXPECT_NEAR(covariance(30.0), -0.4330127 * 10.0 * 10.0 / 4.0, 0.05);
  EXPECT_NEAR(covariance(150.0), 0.4330127 * 10.0 * 10.0 / 4.0, 0.05);
}

TEST(RayKernels, InFocusIsOnePixel) {
  const SpreadKernel kernel =
      ray_kernels(Eye::with(Prescription{-2.0, 0.0, 0.0, 0.0}, 4e-3), 0.0, kernel_pixel, {}).kernel(2.0, 0, 0);
  EXPECT_EQ(kernel.radius_px, 0);
  EXPECT_EQ(kernel.weight(0, 0), 1.0f);
}

TEST(RayKernels, StandUprightInAPicture) {
  // Tilt of W towards +x and +y: ∂(2c r cos θ)/∂x = 2c/a = 2 mrad for 2 µm, and 1 mrad up, so to smaller rows.
  const Eye eye = Eye::with(ZernikeWave::from_examiner(std::vector<double>{0.0, 1e-6, -2e-6}, 2e-3),
                            SecondOrder::LeastSquares, std::nullopt, 4e-3);
  for (const int parts : {1, 4}) {
    const SpreadKernel kernel = ray_kernels(eye, 0.0, 1e-3, {parts, false}).kernel(0.0, parts - 1, 0);
    EXPECT_EQ(kernel.radius_px, 2);
    EXPECT_NEAR(kernel.weight(2, -1), 1.0f, 1e-6);
  }
}

TEST(RayKernels, APartMovesAwayFromTheWholeAsItsShiftSays) {
  const Eye eye = Eye::with(Prescription{-2.0, 0.0, 0.0, 0.0}, 4e-3);
  const KernelModel model = ray_kernels(eye, 0.0, kernel_pixel, {4, false});
  for (int part = 0; part < 4; ++part) {
    // The first sector reaches from the wearer's right to the top: the mean of its points is (a, a)·4/(3π) = 0.4244 a;
    // a vergence V moves light through p to −V p, in pixels to the left and down.
    const double side = 0.4244132 * 2e-3 / kernel_pixel, sign_x = part == 0 || part == 3 ? -1.0 : 1.0,
                 sign_y = part < 2 ? 1.0 : -1.0;
    const Eigen::Vector2d shift = model.parts[static_cast<std::size_t>(part)].shift_px_per_D;
    EXPECT_NEAR(shift.x(), sign_x * side, 2e-3 * side);
    EXPECT_NEAR(shift.y(), sign_y * side, 2e-3 * side);
    // The eye is in focus at 2 D: at 0.5 D the part's kernel stands at −1.5 D of its shift.
    const Moments m = moments(model.kernel(0.5, part, 0));
    EXPECT_NEAR(m.x, -1.5 * shift.x(), 2e-3 * side);
    EXPECT_NEAR(m.y, -1.5 * shift.y(), 2e-3 * side);
  }
}

TEST(RayKernels, AccommodationMovesTheFocus) {
  const Eye eye = Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 4e-3);
  EXPECT_EQ(ray_kernels(eye, 3.0, kernel_pixel, {}).kernel(3.0, 0, 0).radius_px, 0);
  EXPECT_GT(ray_kernels(eye, 3.0, kernel_pixel, {}).kernel(0.0, 0, 0).radius_px, 14);  // 3 D · 2 mm = 15 px
}

TEST(RayKernels, ColoursAreOutOfFocusByTheChromaticEye) {
  // The Indiana eye's 633.46/(λ − 214.102) D [nm], worked out for 612, 549 and 464 nm against 555 nm. The variance of a
  // disc is r²/4; sharing among pixels adds 1/6.
  const Eye eye = Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 8e-3);
  const KernelModel model = ray_kernels(eye, 0.0, 1e-4, {1, true});
  ASSERT_EQ(model.channels, 3);
  const double added_D[] = {0.26621, -0.03329, -0.67668};
  for (int channel = 0; channel < 3; ++channel) {
    const double radius_px = added_D[channel] * 4e-3 / 1e-4, expected = radius_px * radius_px / 4.0;
    EXPECT_NEAR(moments(model.kernel(0.0, 0, channel)).xx, expected + 1.0 / 6.0, 2e-3 * expected + 0.05);
    EXPECT_LT(moments(model.kernel(-added_D[channel], 0, channel)).xx, 0.05);  // there it is in focus
  }
}

TEST(RayKernels, RimOfThePupilCountsLess) {
  // E[t] = 1/q − e^(−q)/(1 − e^(−q)), t = r²/a², q = ρ a² ln 10 = 0.05·16·2.302585: 0.35453 in place of ½.
  Eye eye = Eye::with(Prescription{-2.0, 0.0, 0.0, 0.0}, 8e-3);
  eye.stiles_crawford_per_m2 = 0.05e6;
  const SpreadKernel kernel = ray_kernels(eye, 0.0, kernel_pixel, {}).kernel(0.0, 0, 0);
  EXPECT_NEAR(moments(kernel).xx, 20.0 * 20.0 * 0.35453 / 2.0 + 1.0 / 6.0, 0.1);  // 2 D · 4 mm are 20 px
  // With an inner ring the parts have different shares of the light.
  const KernelModel parts = ray_kernels(eye, 0.0, kernel_pixel, {8, false});
  EXPECT_GT(parts.parts.front().weight, 1.3 * parts.parts.back().weight);
}

TEST(RayKernels, OfAPinholeIsAPoint) {
  const Eye eye = Eye::with(Prescription{-2.0, 0.0, 0.0, 0.0}, 0.0);
  EXPECT_EQ(ray_kernels(eye, 0.0, kernel_pixel, {4, false}).kernel(0.0, 2, 0).radius_px, 0);
}

TEST(RayKernels, BlurBeyondTheLimitIsRefused) {
  const KernelModel model = ray_kernels(Eye::with(Prescription{-20.0, 0.0, 0.0, 0.0}, 8e-3), 0.0, 1e-5, {});
  EXPECT_THROW(model.kernel(0.0, 0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace sturm
