#include <gtest/gtest.h>

#include <algorithm>

#include "compare/metrics/ssim.h"
#include "io/images/tone_map.h"
#include "wavefront/layers/part_count.h"
#include "wavefront/layers/plane_cases.h"
#include "wavefront/layers/unmixed_edges.h"

namespace sturm {
namespace {

using testing::middle;
using testing::plane_eye;
using testing::plane_image;

const nlohmann::json& planes() {
  static const nlohmann::json file = testing::reference_file("planes/planes.json");
  return file;
}

struct Scene {
  std::string name;
  std::vector<PictureLayer> layers;
};

enum class Given { Nothing, Hidden, All };

Scene scene_of(const std::string& name, Given given) {
  Scene scene{name, {}};
  if (given == Given::All) scene.layers = {testing::plane_layer(name, 0, 0.5, true)};
  if (given == Given::Nothing) return scene;
  if (name == "two") scene.layers.push_back(testing::plane_layer("two", 1, 3.0, false));
  if (name == "three") {
    scene.layers.push_back(testing::plane_layer("three", 1, 1.0, true));
    scene.layers.push_back(testing::plane_layer("three", 2, 4.0, false));
  }
  return scene;
}

struct Settings {
  int parts = 1;
  bool chromatic = false;
  double stiles_crawford_per_m2 = 0.0;
};

Image seen(const Scene& scene, const std::string& eye_name, const Settings& settings) {
  auto [eye, accommodation] = plane_eye(planes(), eye_name);
  eye.stiles_crawford_per_m2 = settings.stiles_crawford_per_m2;
  const KernelModel model =
      ray_kernels(eye, accommodation, testing::plane_pixel(planes()), {settings.parts, settings.chromatic});
  LayeredPicture picture = testing::plane_picture(scene.name, 1.0 / model.reach_px_per_D);
  picture.hidden = hidden_by(picture, scene.layers);
  unmix_edges(picture, scene.layers);
  picture.shows_detail = true;
  const KernelBank bank(model, planes_for(picture.vergence_D, model.reach_px_per_D));
  if (scene.layers.empty()) add_guessed_background(picture, bank);
  BlurCounters counters;
  return middle(blur_layers(picture, bank, counters), 256);
}

double rmse(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(a.pixels[i] - b.pixels[i], 2.0);
  return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

/// Which of the 256 × 256 pixels are within `reach` px of a step of the depth map.
std::vector<char> around_steps(const std::string& scene, int reach) {
  const Image depth = middle(plane_image(scene + "_depth"), 256);
  std::vector<char> marked(256 * 256, 0);
  for (int y = 1; y < 256; ++y)
    for (int x = 1; x < 256; ++x) {
      if (*depth.at(x, y) == *depth.at(x - 1, y) && *depth.at(x, y) == *depth.at(x, y - 1)) continue;
      for (int v = std::max(0, y - reach); v <= std::min(255, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(255, x + reach); ++u)
          if (std::hypot(u - x, v - y) <= reach) marked[static_cast<std::size_t>(v) * 256 + u] = 1;
    }
  return marked;
}

/// Similarity in display space, whole and by the distance from steps of the depth map.
struct Similarity {
  double whole, near_edges, away;
};

Similarity similarity(const std::string& scene, const Image& test, const Image& truth) {
  const Image map = ssim(to_display(test, 1.0), to_display(truth, 1.0)).map;
  const std::vector<char> within_16 = around_steps(scene, 16), within_24 = around_steps(scene, 24);
  double sums[3] = {}, counts[3] = {};
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y + 5) * 256 + (x + 5);
      const bool near = within_16[pixel], away = !within_24[pixel];
      for (int region = 0; region < 3; ++region)
        if (region == 0 || (region == 1 && near) || (region == 2 && away)) {
          sums[region] += *map.at(x, y);
          ++counts[region];
        }
    }
  return {sums[0] / counts[0], sums[1] / counts[1], sums[2] / counts[2]};
}

struct Case {
  const char *scene, *eye;
};

class LayeredTruth : public ::testing::TestWithParam<Case> {
 protected:
  /// With the least number of parts that is recommended, and with the usual one.
  void expect_similar(Given given, const Similarity& least) {
    const auto& [scene, eye] = GetParam();
    const Image truth = plane_image(std::string(scene) + "_" + eye + "_truth");
    for (const int parts : {4, 8}) {
      const Similarity s = similarity(scene, seen(scene_of(scene, given), eye, {parts}), truth);
      EXPECT_GE(s.whole, least.whole) << parts;
      EXPECT_GE(s.near_edges, least.near_edges) << parts;
      EXPECT_GE(s.away, least.away) << parts;
      RecordProperty("parts_" + std::to_string(parts),
                     std::to_string(s.whole) + " " + std::to_string(s.near_edges) + " " + std::to_string(s.away));
    }
  }
};

TEST_P(LayeredTruth, HiddenLayersGiven) {
  expect_similar(Given::Hidden, {0.999, 0.996, 0.9995});
}

TEST_P(LayeredTruth, AllLayersGiven) {
  expect_similar(Given::All, {0.999, 0.996, 0.9995});
}

TEST_P(LayeredTruth, PictureAlone) {
  expect_similar(Given::Nothing, {0.996, 0.98, 0.9995});
}

INSTANTIATE_TEST_SUITE_P(Planes, LayeredTruth,
                         ::testing::Values(Case{"two", "myope"}, Case{"two", "astigmat"}, Case{"two", "coma"},
                                           Case{"three", "coma"}),
                         [](const auto& test) { return std::string(test.param.scene) + "_" + test.param.eye; });

double rmse_near_edges(const std::string& scene, const Image& test, const Image& truth) {
  const std::vector<char> near = around_steps(scene, 16);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < test.pixels.size(); ++i)
    if (near[i / 3]) sum += std::pow(test.pixels[i] - truth.pixels[i], 2.0), ++count;
  return std::sqrt(sum / count);
}

TEST(PartsOfThePupil, SlowHaveTheErrorsThatChooseThem) {
  for (const ErrorOfParts& row : errors_of_parts()) {
    double worst = 0.0;
    for (const Case& c : {Case{"two", "myope"}, Case{"two", "astigmat"}, Case{"two", "coma"}, Case{"three", "coma"}}) {
      const Image truth = plane_image(std::string(c.scene) + "_" + c.eye + "_truth");
      worst =
          std::max(worst, rmse_near_edges(c.scene, seen(scene_of(c.scene, Given::Hidden), c.eye, {row.parts}), truth));
    }
    RecordProperty("rms_of_" + std::to_string(row.parts), std::to_string(worst));
    EXPECT_LE(worst, row.error) << row.parts;
    EXPECT_GT(worst, 0.7 * row.error) << row.parts;  // the table is no looser than its rounding
    EXPECT_EQ(parts_for_error(row.error), row.parts);
  }
  EXPECT_EQ(parts_for_error(0.99 * errors_of_parts().back().error), std::nullopt);
}

class FlatTruth : public ::testing::TestWithParam<const char*> {};

TEST_P(FlatTruth, RelativeErrorIsSmall) {
  const auto [eye, accommodation] = plane_eye(planes(), GetParam());
  const KernelModel model = ray_kernels(eye, accommodation, testing::plane_pixel(planes()), {});
  LayeredPicture picture;
  picture.radiance = plane_image("two_layer1");
  picture.vergence_D.assign(picture.radiance.pixels.size() / 3, 1.0 / 3.0);
  picture.shows_detail = true;
  BlurCounters counters;
  const Image test = middle(
      blur_layers(picture, KernelBank(model, planes_for(picture.vergence_D, model.reach_px_per_D)), counters), 128);
  const Image truth = plane_image(std::string("flat_") + GetParam() + "_truth");
  double power = 0.0;
  for (const float v : truth.pixels) power += v * v;
  EXPECT_LE(rmse(test, truth) / std::sqrt(power / static_cast<double>(truth.pixels.size())), 0.002);
}

INSTANTIATE_TEST_SUITE_P(Planes, FlatTruth, ::testing::Values("myope", "astigmat", "coma"));

TEST(LayeredTruthInColour, ChannelsHaveTheirOwnBlur) {
  const Image test = seen(scene_of("two", Given::Hidden), "coma", {4, true});
  EXPECT_LE(rmse(test, plane_image("two_coma_colour_truth")), 0.003);
}

TEST(LayeredTruthInColour, RimOfThePupilCountsLess) {
  for (const int parts : {4, 8}) {  // eight of them have different shares of the light
    const Image test = seen(scene_of("two", Given::Hidden), "coma", {parts, false, 0.05e6});
    EXPECT_LE(rmse(test, plane_image("two_coma_stiles_crawford_truth")), 0.003) << parts;
  }
}

}  // namespace
}  // namespace sturm
