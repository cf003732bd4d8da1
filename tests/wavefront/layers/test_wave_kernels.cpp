#include <gtest/gtest.h>

#include "support/wave_cases.h"
#include "wavefront/layers/wave_kernels.h"
#include "wavefront/psf/wave_kernel.h"
#include "wavefront/psf/wave_sampling.h"

namespace sturm {
namespace {

using testing::arcmin;

Eye measured_eye(const std::vector<double>& osa_um, double measured_mm, double pupil_mm) {
  std::vector<double> metres;
  for (const double c : osa_um) metres.push_back(1e-6 * c);
  return Eye::with(ZernikeWave::from_examiner(metres, 0.5e-3 * measured_mm), SecondOrder::LeastSquares, std::nullopt,
                   1e-3 * pupil_mm);
}

TEST(WaveKernels, AreThoseOfTheFineGrid) {
  const Eye eye = measured_eye(testing::hofer_eye(5), 6.0, 5.0);
  const PupilWave pupil = PupilWave::of(eye, 555);
  const Light light = luminance_weighted_light(20.0);
  const KernelModel model = wave_kernels(eye, 0.0, 2.0 * arcmin, false);
  for (const double vergence : {0.0, 0.7, 2.0}) {
    const SpreadKernel coarse = model.kernel(vergence, 0, 0),
                       fine = wave_kernel(wave_psf(pupil, light, vergence, wave_sampling(pupil, light, vergence)),
                                          2.0 * arcmin, largest_kernel_radius_px);
    const int radius = std::min(fine.radius_px, coarse.radius_px);
    EXPECT_GE(radius, 8);  // where each is cut is decided by a thousandth of the light
    double difference = 0.0;
    for (int y = -radius; y <= radius; ++y)
      for (int x = -radius; x <= radius; ++x) difference += std::abs(fine.weight(x, y) - coarse.weight(x, y));
    EXPECT_LT(difference, 4e-3);  // twice what each leaves out at its rim
  }
}

TEST(WaveKernels, StandUprightInAPicture) {
  // In the wearer's frame the tilts of 2 µm and 1 µm over 4 mm are 2 mrad to the right and 1 mrad up.
  const SpreadKernel kernel =
      wave_kernels(measured_eye({0.0, 1.0, -2.0}, 4.0, 4.0), 0.0, 1e-3, false).kernel(0.0, 0, 0);
  EXPECT_GT(kernel.weight(2, -1), 0.8f);
}

TEST(WaveKernels, AccommodationMovesTheFocus) {
  const Eye eye = measured_eye({0.0}, 4.0, 4.0);
  const KernelModel model = wave_kernels(eye, 3.0, 2.0 * arcmin, false);
  EXPECT_GT(model.kernel(3.0, 0, 0).weight(0, 0), 0.5f);
  EXPECT_LT(model.kernel(0.0, 0, 0).weight(0, 0), 0.05f);
}

TEST(WaveKernels, ColoursAreOutOfFocusByTheChromaticEye) {
  // Blue of 464 nm needs 0.68 D more (the Indiana eye), so it is sharp where a target is that much nearer.
  const KernelModel model = wave_kernels(measured_eye({0.0}, 5.0, 5.0), 0.0, 2.0 * arcmin, true);
  ASSERT_EQ(model.channels, 3);
  EXPECT_GT(model.kernel(0.6769, 0, 2).weight(0, 0), 2.0f * model.kernel(0.0, 0, 2).weight(0, 0));
  EXPECT_GT(model.kernel(0.0, 0, 1).weight(0, 0), 2.0f * model.kernel(0.6769, 0, 1).weight(0, 0));
}

TEST(WaveKernels, NeedAPupil) {
  EXPECT_THROW(wave_kernels(Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 0.0), 0.0, 1e-3, false), std::invalid_argument);
}

}  // namespace
}  // namespace sturm
