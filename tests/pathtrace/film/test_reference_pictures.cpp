// The room of tests/reference/scene_plain as rendered here and by Cycles, cell by cell. A cell is the mean of 16×16
// pixels in one channel (768 of them) or the green of 32 pixels of one row across the lamp (24): blocks know where
// light goes, the lamp's edges how blurred it is.
//
// Statistic. For a cell let x₁ … x_m be its values in m pictures of ours with independent seeds and y₁, y₂ those of the
// two reference pictures. Both are unbiased, with unequal and unknown variances (another sampler, thousands of samples
// against a few), so pooled equal variances would be wrong; the difference is studentised by
//     t = (x̄ − ȳ) / √(s_x²/m + s_y²/2),
// which follows Student's t with Welch and Satterthwaite's degrees of freedom (s_x²/m + s_y²/2)² / ((s_x²/m)²/(m−1) +
// (s_y²/2)²/1). s_y² has one degree of freedom only, but its share of the sum is small, so t stays close to m − 1
// degrees of freedom. Each variance is given a floor of (1e−6·value)², the rounding of stored pixels, for cells wholly
// inside the lamp. With Šidák's correction every p-value must exceed 1 − (1 − 0.01)^(1/cells). Channels of a block go
// together, which makes this conservative.
//
// Many small differences that no cell shows alone show in the mean of t² over independent cells (one channel): E t² =
// ν/(ν − 2), E t⁴ = 3ν²/((ν − 2)(ν − 4)).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "pathtrace/film/render.h"
#include "support/scene_plain.h"
#include "support/scenes.h"
#include "support/student.h"

namespace sturm {
namespace {

constexpr int pictures_of_each = 16, samples = 8;

using Cells = std::vector<double>;

/// What is kept of one picture.
struct Cut {
  Cells blocks[3];  ///< per channel: means of 16×16 pixels, row by row
  Cells lamp;       ///< mean green of each row of the lamp's rectangle
};

Cut cut(const Image& image, const nlohmann::json& lamp) {
  constexpr int block = 16;
  Cut result;
  const int columns = image.width / block, rows = image.height / block;
  for (int k = 0; k < 3; ++k) {
    result.blocks[k].assign(static_cast<std::size_t>(columns * rows), 0.0);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        result.blocks[k][static_cast<std::size_t>(y / block * columns + x / block)] +=
            static_cast<double>(image.at(x, y)[k]) / (block * block);
  }
  const int left = lamp["x"], top = lamp["y"], width = lamp["width"], height = lamp["height"];
  for (int y = top; y < top + height; ++y) {
    result.lamp.push_back(0.0);
    for (int x = left; x < left + width; ++x) result.lamp.back() += static_cast<double>(image.at(x, y)[1]) / width;
  }
  return result;
}

std::vector<Cut> reference(const nlohmann::json& file, const std::string& variant) {
  std::vector<Cut> seeds;
  for (const auto& seed : file["variants"][variant]["seeds"]) {
    Cut c;
    const Cells interleaved = seed["block_means"];
    for (std::size_t i = 0; i < interleaved.size(); ++i) c.blocks[i % 3].push_back(interleaved[i]);
    c.lamp = seed["lamp_rows"].get<Cells>();
    seeds.push_back(c);
  }
  return seeds;
}

std::vector<Cut> ours(const nlohmann::json& file, const EyeRays<float>& rays) {
  const Scene scene(testing::scene_plain());
  const EyeCamera camera(testing::scene_plain_pose(), rays);
  std::vector<Cut> pictures;
  for (int seed = 1; seed <= pictures_of_each; ++seed) {
    RenderSettings settings;
    settings.samples_per_pixel = samples;
    settings.max_bounces = 16;
    settings.seed = static_cast<std::uint64_t>(seed);
    pictures.push_back(cut(render(scene, camera, settings).radiance, file["lamp_rectangle"]));
  }
  return pictures;
}

struct Sample {
  double mean, variance_of_mean, degrees;
};

template <class Select>
Sample summary(const std::vector<Cut>& pictures, std::size_t cell, Select&& cells) {
  const double n = static_cast<double>(pictures.size());
  double mean = 0.0, squares = 0.0;
  for (const Cut& p : pictures) mean += cells(p)[cell] / n;
  for (const Cut& p : pictures) squares += std::pow(cells(p)[cell] - mean, 2);
  return {mean, squares / (n - 1.0) / n + std::pow(1e-6 * mean, 2), n - 1.0};
}

/// `cells` picks one channel's cells; `family` is the number of cells that are tested together.
template <class Select>
void expect_same(const std::vector<Cut>& a, const std::vector<Cut>& b, std::size_t family, const std::string& what,
                 Select&& cells) {
  const std::size_t count = cells(a[0]).size();
  ASSERT_EQ(cells(b[0]).size(), count) << what;
  double least_p = 1.0, mean_a = 0.0, mean_b = 0.0, squares = 0.0;
  std::string worst;
  for (std::size_t i = 0; i < count; ++i) {
    const Sample x = summary(a, i, cells), y = summary(b, i, cells);
    mean_a += x.mean;
    mean_b += y.mean;
    const double variance = x.variance_of_mean + y.variance_of_mean;
    const double degrees = variance * variance /
                           (std::pow(x.variance_of_mean, 2) / x.degrees + std::pow(y.variance_of_mean, 2) / y.degrees);
    const double t = (x.mean - y.mean) / std::sqrt(variance), p = testing::student_two_sided(t, degrees);
    squares += t * t / static_cast<double>(count);
    if (p >= least_p) continue;
    least_p = p;
    worst = "cell " + std::to_string(i) + ": " + std::to_string(x.mean) + " against " + std::to_string(y.mean) +
            ", t = " + std::to_string(t);
  }
  EXPECT_NEAR(mean_a / mean_b, 1.0, 0.003) << what << ": mean";
  EXPECT_GT(least_p, 1.0 - std::pow(1.0 - 0.01, 1.0 / static_cast<double>(family))) << what << ": " << worst;
  constexpr double nu = pictures_of_each - 1, expected = nu / (nu - 2.0),
                   fourth = 3.0 * nu * nu / ((nu - 2.0) * (nu - 4.0));
  EXPECT_LT(squares, expected + 5.0 * std::sqrt((fourth - expected * expected) / static_cast<double>(count)))
      << what << ": mean of t²";
  std::printf("%s: mean ratio %.5f, mean t² %.3f, least p %.2g\n", what.c_str(), mean_a / mean_b, squares, least_p);
}

void expect_same_picture(const std::string& variant, const EyeRays<float>& rays) {
  const auto file = testing::reference_file("scene_plain/block_means.json");
  const std::vector<Cut> a = ours(file, rays), b = reference(file, variant);
  ASSERT_EQ(b.size(), 2u);
  for (std::size_t k = 0; k < 3; ++k)
    expect_same(a, b, 768, "blocks of channel " + std::to_string(k),
                [k](const Cut& c) -> const Cells& { return c.blocks[k]; });
  expect_same(a, b, a[0].lamp.size(), "rows across the lamp", [](const Cut& c) -> const Cells& { return c.lamp; });
}

TEST(Student, KnowsItsTables) {
  EXPECT_NEAR(testing::student_two_sided(12.706, 1.0), 0.05, 1e-5);
  EXPECT_NEAR(testing::student_two_sided(2.1314, 15.0), 0.05, 1e-5);
  EXPECT_NEAR(testing::student_two_sided(-4.0728, 15.0), 0.001, 1e-6);
  EXPECT_NEAR(testing::student_two_sided(1.95996, 1e7), 0.05, 1e-6);
}

TEST(SlowReferencePictures, Pinhole) {
  expect_same_picture("pinhole", testing::pinhole_rays());
}

TEST(SlowReferencePictures, LensOf20MillimetresFocusedAt105Centimetres) {
  expect_same_picture("dof20", testing::focused_lens(0.02, 1.05));
}

}  // namespace
}  // namespace sturm
