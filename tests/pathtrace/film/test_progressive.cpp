// Pictures in passes: the same bits as in one go, and what the caller sees between passes.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <vector>

#include "pathtrace/film/progressive_render.h"
#include "support/same_bytes.h"
#include "support/scene_plain.h"

namespace sturm {
namespace {

using testing::same_bytes;

RenderSettings settings_of(int samples, Sequence sequence = Sequence::Sobol) {
  RenderSettings settings;
  settings.samples_per_pixel = samples;
  settings.sequence = sequence;
  settings.guide_emitters = true;
  return settings;
}

EyeCamera camera() {
  CameraPose pose = testing::scene_plain_pose();
  pose.width = 50;  // not a multiple of the tile
  pose.height = 37;
  return {pose, testing::focused_lens(0.02, 1.05)};
}

void expect_same(const RenderResult& a, const RenderResult& b) {
  EXPECT_TRUE(same_bytes(a.radiance, b.radiance));
  EXPECT_TRUE(same_bytes(a.variance, b.variance));
  EXPECT_TRUE(same_bytes(a.albedo, b.albedo));
  EXPECT_TRUE(same_bytes(a.normal, b.normal));
  EXPECT_TRUE(same_bytes(a.depth, b.depth));
  EXPECT_TRUE(same_bytes(a.guide_mean, b.guide_mean));
  EXPECT_TRUE(same_bytes(a.guide_variance, b.guide_variance));
  EXPECT_EQ(a.counters.bounce_rays, b.counters.bounce_rays);
  EXPECT_EQ(a.counters.shadow_rays, b.counters.shadow_rays);
  EXPECT_EQ(a.counters.camera.launched, b.counters.camera.launched);
}

TEST(Progressive, PassesAreTheSameBitsAsOneGo) {
  const Scene scene(testing::scene_plain());
  for (const Sequence sequence : {Sequence::Sobol, Sequence::Halton, Sequence::Independent}) {
    RenderSettings settings = settings_of(41, sequence);  // the last pass is not full
    settings.guide_layers = true;
    const RenderResult at_once = render(scene, camera(), settings);
    settings.after_pass = [](const PassReport&) { return true; };
    for (const int threads : {1, 3}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
      const RenderResult in_passes = render(scene, camera(), settings);
      expect_same(at_once, in_passes);
      EXPECT_EQ(in_passes.passes.passes, 3);
      EXPECT_FALSE(in_passes.passes.interrupted);
      EXPECT_EQ(in_passes.passes.samples_spent, 50u * 37u * 41u);
      EXPECT_EQ(in_passes.passes.samples_saved, 0u);
    }
  }
}

TEST(Progressive, WhatIsSeenBetweenPassesIsThePictureOfSoManySamples) {
  const Scene scene(testing::scene_plain());
  RenderSettings settings = settings_of(64);
  std::vector<Image> seen;
  std::vector<double> fractions;
  settings.after_pass = [&](const PassReport& report) {
    seen.push_back(report.picture_so_far());
    fractions.push_back(report.fraction);
    return true;
  };
  render(scene, camera(), settings);
  EXPECT_EQ(fractions, (std::vector<double>{0.25, 0.5, 0.75}));  // after the last pass there is nothing left to decide
  ASSERT_EQ(seen.size(), 3u);
  for (std::size_t i = 0; i < seen.size(); ++i)
    EXPECT_TRUE(same_bytes(seen[i], render(scene, camera(), settings_of(16 * static_cast<int>(i + 1))).radiance));
}

TEST(Progressive, AnInterruptedPictureIsThatOfFewerSamples) {
  const Scene scene(testing::scene_plain());
  RenderSettings settings = settings_of(1000);
  int calls = 0;
  settings.after_pass = [&](const PassReport&) { return ++calls < 2; };
  const RenderResult interrupted = render(scene, camera(), settings);
  expect_same(interrupted, render(scene, camera(), settings_of(32)));
  EXPECT_TRUE(interrupted.passes.interrupted);
  EXPECT_EQ(interrupted.passes.samples_kept, 50u * 37u * 32u);
  EXPECT_EQ(interrupted.passes.samples_saved, 50u * 37u * 968u);
}

}  // namespace
}  // namespace sturm
