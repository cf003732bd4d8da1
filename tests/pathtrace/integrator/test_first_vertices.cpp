// Light of the first vertices of a block, with its shadow rays in packets, against paths that are traced on their own.
#include <gtest/gtest.h>

#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/integrator/path_tracer.h"
#include "support/scene_plain.h"

namespace sturm {
namespace {

/// How the paths of all blocks of a row of pixels compare with and without light that is known beforehand.
struct Compared {
  RenderCounters together, alone;
  int paths = 0, shadowed = 0;
};

Compared compared(const Scene& scene, int count) {
  const EyeCamera camera(testing::scene_plain_pose(), testing::focused_lens(0.02, 1.05));
  const RenderSettings settings;
  const PathTracer tracer(scene, settings);
  Compared sum;
  CameraHits hits;
  FirstVertices vertices;
  for (int x = 0; x < camera.width(); x += 4) {
    const int y = 7 * camera.height() / 10;
    const PixelSequence sequence(Sequence::Sobol, 5, static_cast<std::uint32_t>(x));
    VertexNumbers numbers(sequence);
    numbers.begin_block(32, count);
    trace_camera_rays(scene, camera, x, y, 32, count, sequence, hits);
    for (int i = 0; i < count; ++i)
      if (hits.hit(i))
        vertices.at[i] = scene.surface_point(hits.record(i), hits.origin(i), hits.direction(i), hits.distance(i));
    tracer.light(vertices, hits, 32, count, numbers, sum.together);
    EXPECT_TRUE(vertices.lit);
    for (int i = 0; i < count; ++i) {
      if (!hits.hit(i)) continue;
      const std::uint32_t sample = 32 + static_cast<std::uint32_t>(i);
      const Eigen::Vector3f together = tracer.radiance(vertices.at[i], hits.direction(i), numbers, sample, sum.together,
                                                       {1.0f, &vertices.direct_light[i]});
      const Eigen::Vector3f alone = tracer.radiance(vertices.at[i], hits.direction(i), numbers, sample, sum.alone);
      EXPECT_EQ(together, alone) << "pixel " << x << ", sample " << i;
      ++sum.paths;
      sum.shadowed += vertices.direct_light[i].isZero();
    }
  }
  return sum;
}

TEST(FirstVertices, LightInPacketsIsThatOfSinglePaths) {
  const Scene scene(testing::scene_plain());
  for (int count : {16, 11, 8, 3}) {
    const Compared c = compared(scene, count);
    EXPECT_EQ(c.together.shadow_rays, c.alone.shadow_rays);
    EXPECT_EQ(c.together.bounce_rays, c.alone.bounce_rays);
    EXPECT_GT(c.paths, 60 * count);
    EXPECT_GT(c.shadowed,
              c.paths / 50);  // the boxes' shadows on the floor: packets that stop nothing would not be seen otherwise
    EXPECT_LT(c.shadowed, c.paths);
  }
}

TEST(FirstVertices, ScenesWithOtherLoopsAreLeftToThem) {
  SceneDescription description = testing::scene_plain();
  description.environment = Environment{};
  description.environment->radiance = Eigen::Vector3f::Ones();
  const Scene scene(description);
  FirstVertices vertices;
  RenderCounters counters;
  const PixelSequence sequence(Sequence::Sobol, 1, 1);
  VertexNumbers numbers(sequence);
  PathTracer(scene, {}).light(vertices, CameraHits{}, 0, 16, numbers, counters);
  EXPECT_FALSE(vertices.lit);
  EXPECT_EQ(counters.shadow_rays, 0u);
}

}  // namespace
}  // namespace sturm
