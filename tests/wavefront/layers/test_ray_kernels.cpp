#include <gtest/gtest.h>

#include "wavefront/layers/ray_kernels.h"

namespace sturm {
namespace {

constexpr double pixel = 4e-4;

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
  const KernelModel whole = ray_kernels(eye, 0.0, pixel, {1, false}), parts = ray_kernels(eye, 0.0, pixel, {4, false});
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
      ray_kernels(Eye::with(Prescription{-2.0, 0.0, 0.0, 0.0}, 4e-3), 0.0, pixel, {}).kernel(0.5, 0, 0);
  EXPECT_NEAR(moments(kernel).xx, 7.5 * 7.5 / 4.0 + 1.0 / 6.0, 0.01);
  EXPECT_NEAR(moments(kernel).xy, 0.0, 0.01);
}

TEST(RayKernels, AxisThirtyTurnsTheOtherWayThanAxisOneHundredAndFifty) {
  const auto covariance = [](double axis) {
    return moments(ray_kernels(Eye::with(Prescription{0.0, -2.0, axis, 0.0}, 4e-3), 0.0, pixel, {}).kernel(0.0, 0, 0))
        .xy;
  };
  // AXIS 30 is the meridian 150° of the wearer; power acts across it, along 60°: up and to the right, where rows go
  // down, so that right and down vary against each other. C a = 4 mrad = 10 px along it.
  EXPECT_NEAR(covariance(30.0), -0.4330127 * 10.0 * 10.0 / 4.0, 0.05);
  EXPECT_NEAR(covariance(150.0), 0.4330127 * 10.0 * 10.0 / 4.0, 0.05);
}

TEST(RayKernels, InFocusIsOnePixel) {
  const SpreadKernel kernel =
      ray_kernels(Eye::with(Prescription{-2.0, 0.0, 0.0, 0.0}, 4e-3), 0.0, pixel, {}).kernel(2.0, 0, 0);
  EXPECT_EQ(kernel.radius_px, 0);
  EXPECT_EQ(kernel.weight(0, 0), 1.0f);
}

TEST(RayKernels, BlurBeyondTheLimitIsRefused) {
  const KernelModel model = ray_kernels(Eye::with(Prescription{-20.0, 0.0, 0.0, 0.0}, 8e-3), 0.0, 1e-5, {});
  EXPECT_THROW(model.kernel(0.0, 0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace sturm
