#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>

#include "pathtrace/film/render.h"
#include "support/same_bytes.h"
#include "support/scene_plain.h"

namespace sturm {
namespace {

using testing::same_bytes;

RenderResult picture(const Scene& scene, std::uint64_t seed, int threads, Sequence sequence = Sequence::Sobol) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  CameraPose pose = testing::scene_plain_pose();
  pose.width = 70;  // not a multiple of the tile
  pose.height = 45;
  RenderSettings settings;
  settings.samples_per_pixel = 20;  // not a multiple of the block
  settings.seed = seed;
  settings.sequence = sequence;
  return render(scene, EyeCamera(pose, testing::focused_lens(0.02, 1.05)), settings);
}

bool same_bytes(const RenderResult& a, const RenderResult& b) {
  return same_bytes(a.radiance, b.radiance) && same_bytes(a.variance, b.variance) && same_bytes(a.albedo, b.albedo) &&
         same_bytes(a.normal, b.normal) && same_bytes(a.depth, b.depth);
}

TEST(Determinism, TheSameBitsForAnyNumberOfThreads) {
  const Scene scene(testing::scene_plain());
  const RenderResult one = picture(scene, 1, 1);
  for (int threads : {1, 2, 3}) {
    const RenderResult other = picture(scene, 1, threads);
    EXPECT_TRUE(same_bytes(one, other)) << threads;
    EXPECT_EQ(one.counters.bounce_rays, other.counters.bounce_rays);
    EXPECT_EQ(one.counters.shadow_rays, other.counters.shadow_rays);
    EXPECT_EQ(one.counters.camera.launched, other.counters.camera.launched);
  }
  const Scene rebuilt(testing::scene_plain());
  EXPECT_TRUE(same_bytes(one, picture(rebuilt, 1, 2)));
  EXPECT_TRUE(same_bytes(picture(scene, 1, 1, Sequence::Independent), picture(scene, 1, 2, Sequence::Independent)));
}

TEST(Determinism, SeedsAndSequencesDiffer) {
  const Scene scene(testing::scene_plain());
  const RenderResult one = picture(scene, 1, 2);
  EXPECT_FALSE(same_bytes(one, picture(scene, 2, 2)));
  EXPECT_FALSE(same_bytes(one, picture(scene, 1 + (1ull << 32), 2)));
  EXPECT_FALSE(same_bytes(one, picture(scene, 1, 2, Sequence::Independent)));
}

TEST(Progress, ReachesOne) {
  const Scene scene(testing::scene_plain());
  RenderSettings settings;
  settings.samples_per_pixel = 1;
  std::atomic<double> highest{0.0};
  std::atomic<int> calls{0};
  settings.progress = [&](double fraction) {
    ++calls;
    double seen = highest;
    while (fraction > seen && !highest.compare_exchange_weak(seen, fraction)) {
    }
  };
  CameraPose pose = testing::scene_plain_pose();
  pose.width = pose.height = 40;
  render(scene, EyeCamera(pose, testing::focused_lens(0.02, 1.05)), settings);
  EXPECT_EQ(highest, 1.0);
  EXPECT_GE(calls, 4);
}

}  // namespace
}  // namespace sturm
