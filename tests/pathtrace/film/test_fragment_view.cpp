// Sharp views piece by piece, as predictions use them.
#include <gtest/gtest.h>

#include <cmath>

#include "pathtrace/film/fragment_view.h"
#include "support/scene_plain.h"
#include "support/scenes.h"

namespace sturm {
namespace {

/// Chief rays of a pinhole camera, of its whole picture in `width` × `width` pixels.
struct Pinhole {
  CameraPose pose;
  int width;

  double slope() const { return pixel_slope(pose) * pose.height / width; }
  std::optional<LightRay> operator()(double x, double y) const {
    const Eigen::Vector3d toward((x - 0.5 * width) * slope(), (0.5 * width - y) * slope(), -1.0);
    return LightRay{pose.position, head_axes(pose) * toward};
  }
};

FragmentImage view_of(const Scene& scene, const Pinhole& camera, const RenderSettings& settings) {
  RenderCounters counters;
  return render_fragments(scene, camera.width, camera.width, camera, camera.slope(), settings, counters);
}

Scene with_environment() {
  SceneDescription description = testing::scene_plain();
  description.meshes.resize(description.meshes.size() / 2);  // parts of the room are open
  description.environment = Environment{};
  description.environment->radiance = {0.3f, 0.4f, 0.7f};
  return Scene(description);
}

/// Paths of at most one reflection have the same numbers, so that the direct part is their radiance to the last bit.
void expect_direct_part(const Scene& scene, Scene::Kind kind) {
  const Pinhole camera{testing::scene_plain_pose(), 24};
  RenderSettings settings;
  settings.samples_per_pixel = 8;
  settings.least_kind = kind;
  const FragmentImage all = view_of(scene, camera, settings);
  settings.max_bounces = 1;
  const FragmentImage direct = view_of(scene, camera, settings);
  ASSERT_EQ(all.fragments.size(), direct.fragments.size());
  double indirect = 0.0;
  for (std::size_t i = 0; i < all.fragments.size(); ++i) {
    EXPECT_EQ(all.fragments[i].direct, direct.fragments[i].radiance) << i;
    EXPECT_EQ(all.fragments[i].direct_variance, direct.fragments[i].direct_variance) << i;
    EXPECT_EQ(direct.fragments[i].indirect_variance, Eigen::Vector3f::Zero()) << i;
    indirect += static_cast<double>((all.fragments[i].radiance - all.fragments[i].direct).sum());
  }
  EXPECT_GT(indirect, 0.0);
}

TEST(FragmentView, DirectLightIsThatOfPathsWithOneReflection) {
  const Scene room(testing::scene_plain()), open = with_environment();
  for (const Scene::Kind kind : {Scene::Kind::plain, Scene::Kind::diffuse, Scene::Kind::mixed}) {
    SCOPED_TRACE(static_cast<int>(kind));
    expect_direct_part(room, kind);
    if (kind != Scene::Kind::plain) expect_direct_part(open, kind);
  }
}

TEST(FragmentView, PixelsOfATileSpreadTheirSamplesOverOneAnother) {
  // Variances over seeds of pixels, and of the means of 4 × 4 pixels. Of independent pixels the latter is a sixteenth
  // of the mean of the former; with 31 degrees of freedom in each of 64 blocks their ratio would be 1 ± √(2/(31·64)) =
  // 1 ± 0.032.
  constexpr int size = 32, block = 4, seeds = 32;
  const Scene scene(testing::scene_plain());
  const Pinhole camera{testing::scene_plain_pose(), size};
  RenderSettings settings;
  settings.samples_per_pixel = 4;
  settings.max_bounces = 1;  // longer paths gain less
  std::vector<std::vector<double>> pictures;
  for (int seed = 0; seed < seeds; ++seed) {
    settings.seed = 100 + static_cast<std::uint64_t>(seed);
    const FragmentImage view = view_of(scene, camera, settings);
    auto& picture = pictures.emplace_back();
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        double sum = 0.0;
        for (const Fragment& f : view.at(x, y))
          if (!f.emits) sum += static_cast<double>(f.share * f.radiance.y());
        picture.push_back(sum);
      }
  }
  const auto variance = [&](const auto& value_of) {
    double sum = 0.0, squares = 0.0;
    for (const auto& picture : pictures) {
      const double v = value_of(picture);
      sum += v / seeds;
      squares += v * v / seeds;
    }
    return (squares - sum * sum) * seeds / (seeds - 1);
  };
  double of_pixels = 0.0, of_blocks = 0.0;
  for (int y = 0; y < size; y += block)
    for (int x = 0; x < size; x += block) {
      const auto pixel = [&](int k) { return static_cast<std::size_t>((y + k / block) * size + x + k % block); };
      for (int k = 0; k < block * block; ++k)
        of_pixels += variance([&](const auto& picture) { return picture[pixel(k)]; }) / (block * block);
      of_blocks += variance([&](const auto& picture) {
        double sum = 0.0;
        for (int k = 0; k < block * block; ++k) sum += picture[pixel(k)];
        return sum / (block * block);
      });
    }
  EXPECT_LT(of_blocks * block * block / of_pixels, 1.0 - 4 * 0.032);
}

TEST(FragmentView, ALampsShareIsKnownBetterThanByItsSamples) {
  // A lamp in the right 0.7 of the middle pixel, before nothing.
  Pinhole camera{{}, 3};
  const auto x = static_cast<float>((1.3 - 1.5) * camera.slope());
  SceneDescription description;
  description.materials = {testing::lambertian(Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones())};
  description.meshes = {testing::parallelogram({x, -9.0f, -1.0f}, {9.0f, 0.0f, 0.0f}, {0.0f, 18.0f, 0.0f}, 0)};
  RenderSettings settings;
  settings.samples_per_pixel = 4;
  const FragmentImage view = view_of(Scene(description), camera, settings);
  ASSERT_EQ(view.at(1, 1).size(), 2u);
  for (const Fragment& f : view.at(1, 1)) {
    // 256 of the 260 samples are a net: each column of 1/256 has one. The other 4 may all lie on one side.
    EXPECT_NEAR(f.share, f.emits ? 0.7 : 0.3, (1.0 + 4.0) / 260);
    // A uniform strip of that width.
    EXPECT_NEAR(f.spread[0], static_cast<double>(f.share * f.share) / 12.0, 0.02 * f.share);
    EXPECT_NEAR(f.middle.x(), f.emits ? 0.65 : 0.15, 0.02);
  }
}

}  // namespace
}  // namespace sturm
