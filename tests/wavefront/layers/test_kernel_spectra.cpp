#include <gtest/gtest.h>

#include "wavefront/layers/flat_pictures.h"
#include "wavefront/layers/kernel_spectra.h"
#include "wavefront/layers/ray_kernels.h"

namespace sturm {
namespace {

TEST(KernelSpectra, AreTheSameWhetherTheyAreKeptOrNot) {
  const KernelModel model = ray_kernels(testing::astigmatic_myope(5.0), 0.0, 0.25 * testing::flat_pixel, {4, true});
  const KernelBank bank(model, {0.0, 2.0, 4.0});
  const BlurPlan plan(bank);
  ASSERT_TRUE(plan.transforms(2));
  const std::size_t bytes =
      sizeof(float) * static_cast<std::size_t>(plan.side()) * static_cast<std::size_t>(plan.side());
  const KernelSpectra all(bank, plan), some(bank, plan, 5 * bytes), none(bank, plan, 0);
  KernelSpectra::Scratch unused, for_some, for_none;
  for (int plane = 0; plane < 3; ++plane) {
    if (!plan.transforms(plane)) continue;
    for (int part = 0; part < 4; ++part)
      for (const int channel : {0, 1, 2, 0, 1, 2}) {
        const Image& kept = all.of(plane, part, channel, unused);
        EXPECT_EQ(some.of(plane, part, channel, for_some).pixels, kept.pixels);
        EXPECT_EQ(none.of(plane, part, channel, for_none).pixels, kept.pixels);
      }
  }
  EXPECT_TRUE(unused.tile.pixels.empty());
  EXPECT_FALSE(for_some.tile.pixels.empty());
}

}  // namespace
}  // namespace sturm
