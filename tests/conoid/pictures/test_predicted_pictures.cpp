#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "conoid/pictures/flat_scene.h"
#include "conoid/pictures/layered_predictor.h"
#include "conoid/pictures/pupil_passes.h"

namespace sturm {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double picture_slope = 4e-3;

PicturePlane picture(int width, int height, Gaze gaze = Gaze::Camera) {
  PicturePlane p;
  p.width = width;
  p.height = height;
  p.pixel_slope = picture_slope;
  p.gaze = gaze;
  return p;
}

Card wall(double z, std::function<double(double, double)> radiance) {
  return {z, -50.0, 50.0, -50.0, 50.0, std::move(radiance)};
}
double white(double, double) {
  return 1.0;
}

Image by_passes(const FlatScene& scene, const SightField& field, int passes) {
  PassSettings settings;
  settings.passes = passes;
  return predict_by_passes(scene.sharp_view(field), 1, field, scene.first_hits(), scene.shader(), settings).radiance;
}

Image by_layers(const FlatScene& scene, const SightField& field, int oversampling = 1) {
  PassSettings settings;
  settings.passes = 16 * oversampling * oversampling;
  PassCounters counters;
  const FragmentImage view = scene.sharp_view(field, oversampling);
  const auto unseen = unseen_pieces(view, oversampling, field, scene.first_hits(), scene.shader(), settings, counters);
  return predict_by_layers(view, oversampling, field, unseen).radiance;
}

/// What the eye sees of the cards, ray by ray: `rings` × 6k points of the pupil by midpoints in r², 4 × 4 places in the
/// pixel.
Image brute_force(const FlatScene& scene, const SightField& field) {
  const PicturePlane& p = field.plane();
  const double a = field.eye().pupil_radius_m;
  const Eigen::Matrix2d s = field.eye().slope_matrix(field.eye().accommodation_for(0.0)).matrix();
  Image image(p.width, p.height, 3);
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) {
      double sum = 0.0;
      for (int k = 0; k < 16; ++k) {
        const Vector2d q = p.slope({x + (k % 4 + 0.5) / 4, y + (k / 4 + 0.5) / 4});
        for (int ring = 0; ring < 12; ++ring)
          for (int j = 0; j < 48; ++j) {
            const double r = a * std::sqrt((ring + 0.5) / 12),
                         angle = 2.0 * pi * (j + 0.5 + 0.37 * ring + 0.11 * k) / 48;
            const Vector2d point(r * std::cos(angle), r * std::sin(angle)), direction = q + s * point;
            sum += scene.radiance({point.x(), point.y(), 0.0}, {direction.x(), direction.y(), -1.0});
          }
      }
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(sum / (16 * 12 * 48));
    }
  return image;
}

double largest_difference(const Image& a, const Image& b, int border = 0) {
  double largest = 0.0;
  for (int y = border; y < a.height - border; ++y)
    for (int x = border; x < a.width - border; ++x)
      largest = std::max(largest, static_cast<double>(std::abs(a.at(x, y)[0] - b.at(x, y)[0])));
  return largest;
}

double rms_difference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(a.pixels[i] - b.pixels[i], 2);
  return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

TEST(PupilPasses, FillTheDiscEvenly) {
  for (const int count : {16, 64, 256}) {
    double squares = 0.0;
    Vector2d mean(0.0, 0.0), film(0.0, 0.0);
    for (const PupilPass& pass : pupil_passes(count, 0.3)) {
      squares += pass.pupil.cast<double>().squaredNorm() / count;
      mean += pass.pupil.cast<double>() / count;
      film += pass.film.cast<double>() / count;
    }
    EXPECT_NEAR(squares, 0.5, 1e-6);      // float; the sum of (k + ½)/n² is exactly ½
    EXPECT_LT(mean.norm(), 1.0 / count);  // a sunflower's centroid: below one point's share
    EXPECT_LT((film - Vector2d(0.5, 0.5)).cwiseAbs().maxCoeff(), 2.0 / count);  // low discrepancy: O(log n/n)
  }
}

TEST(PupilPasses, NeighboursTakeOtherPoints) {
  const auto sets = interleaved_passes(8);
  ASSERT_EQ(sets.size(), 16u);
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT((sets[i][0].pupil - sets[j][0].pupil).norm(), 1e-3f);
}

TEST(PredictedPictures, AConstantRoomStaysConstant) {
  const auto grey = [](double, double) { return 0.7; };
  const FlatScene scene({{-0.6, -0.1, 0.05, -1.0, 0.02, grey}, wall(-2.0, grey)});
  const SightField field(picture(40, 30), Eye::with(Prescription{-1.0, -3.0, 30.0, 0.0}, 1e-2), std::nullopt);
  for (const float v : by_passes(scene, field, 32).pixels) EXPECT_NEAR(v, 0.7f, 1e-6f);  // float
  for (const float v : by_layers(scene, field).pixels) EXPECT_NEAR(v, 0.7f, 1e-6f);
}

struct PictureMoments {
  double mass = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;  // [px], y up
};

PictureMoments moments(const Image& image) {
  PictureMoments m;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double w = image.at(x, y)[0], right = x + 0.5 - 0.5 * image.width, up = 0.5 * image.height - y - 0.5;
      m.mass += w, m.x += w * right, m.y += w * up;
      m.xx += w * right * right, m.xy += w * right * up, m.yy += w * up * up;
    }
  m.x /= m.mass, m.y /= m.mass;
  m.xx = m.xx / m.mass - m.x * m.x, m.xy = m.xy / m.mass - m.x * m.y, m.yy = m.yy / m.mass - m.y * m.y;
  return m;
}

class LampInTheDark : public ::testing::TestWithParam<double> {};

// A square lamp of one pixel, 1 m away, before nothing. V = 1 − 1 − 4 u uᵀ with u across the axis: the light lies on a
// segment along u of half length 10 mm · 4 D = 40 mrad = 10 px; a²/4 · 16/picture_slope² = 25 px² of variance along u.
// AXIS 30 stands at the wearer's 150°, u at 60°.
TEST_P(LampInTheDark, IsItsEllipse) {
  const double h = 0.5 * picture_slope;
  const FlatScene scene({{-1.0, -h, h, -h, h, white}});
  const SightField field(picture(41, 41), Eye::with(Prescription{-1.0, -4.0, GetParam(), 0.0}, 2e-2), std::nullopt);
  const double mirror = GetParam() == 30.0 ? 1.0 : -1.0;
  const auto expect = [&](const Image& image, double tolerance) {
    const PictureMoments m = moments(image);
    EXPECT_NEAR(m.mass, 1.0, 0.06);  // passes: some 1024 rays in all meet the lamp; random ones would scatter by 3 %
    EXPECT_NEAR(m.x, 0.0, 0.1);
    EXPECT_NEAR(m.y, 0.0, 0.1);
    // The lamp itself and the pixel: 1/12 px² each; of ellipses a third one for the sharp pixel.
    EXPECT_NEAR(m.xx, 6.25 + 0.2, tolerance);
    EXPECT_NEAR(m.xy, mirror * 10.825, tolerance);
    EXPECT_NEAR(m.yy, 18.75 + 0.2, tolerance);
  };
  expect(by_passes(scene, field, 1024), 0.4);  // 2 % of 25 px²
  expect(by_layers(scene, field), 0.15);
}

INSTANTIATE_TEST_SUITE_P(Axes, LampInTheDark, ::testing::Values(30.0, 150.0));

TEST(PredictedPictures, ABlurredEdgeHasTheProfileOfItsDisc) {
  // A black card to the left before a white wall in focus: 10 mm · 1.5 D = 15 mrad = 3.75 px of radius.
  const FlatScene scene({{-0.5, -9.0, 0.0, -9.0, 9.0, [](double, double) { return 0.0; }}, wall(-2.0, white)});
  const SightField field(picture(32, 16), Eye::with(Prescription{}, 2e-2, FixedAccommodation{0.5, 2.0}), std::nullopt);
  const auto covered = [](double distance_px) {
    const double s = std::clamp(distance_px / 3.75, -1.0, 1.0);
    return 0.5 - (std::asin(s) + s * std::sqrt(1.0 - s * s)) / pi;
  };
  const Image passes = by_passes(scene, field, 256), layers = by_layers(scene, field);
  for (int x = 0; x < 32; ++x) {
    const double expected = 1.0 - covered(x + 0.5 - 16.0);
    // An edge through 256 even points: O(N^-3/4) = 0.016 in each pixel, less in the mean over the four rows of the
    // pattern.
    EXPECT_NEAR(passes.at(x, 8)[0], expected, 0.03) << x;
    EXPECT_NEAR(0.25 * (passes.at(x, 4)[0] + passes.at(x, 5)[0] + passes.at(x, 6)[0] + passes.at(x, 7)[0]), expected,
                0.016)
        << x;
    EXPECT_NEAR(layers.at(x, 8)[0], expected, 0.02) << x;  // box-sampled in source and output: density'/6 < 0.02
  }
}

FlatScene post_before_a_wall(double wall_z) {
  const auto stripes = [](double x, double y) { return 0.5 + 0.4 * std::sin(9.0 * x / 2.0) * std::cos(4.0 * y); };
  return FlatScene(
      {{-0.5, -0.012, 0.012, -9.0, 9.0, [](double, double y) { return 0.1 + 0.3 * y; }}, wall(wall_z, stripes)});
}

TEST(PredictedPictures, APostInFrontOfASharpOrABlurredWallIsLikeBruteForce) {
  for (const double wall_z : {-2.0, -8.0}) {  // in focus at 2 m, and 0.375 D beyond: 0.94 px
    const FlatScene scene = post_before_a_wall(wall_z);
    const SightField field(picture(48, 8), Eye::with(Prescription{}, 2e-2, FixedAccommodation{0.5, 2.0}), std::nullopt);
    const Image truth = brute_force(scene, field), passes = by_passes(scene, field, 1024),
                layers = by_layers(scene, field);
    // The post is 12 px wide, its blur 7.5 px: the wall shows through all but its middle. Contrast 0.8 at the most.
    EXPECT_LT(largest_difference(passes, truth), 0.02)
        << wall_z;  // 0.8 · O(N^-3/4) and the brute force's own 576 points
    EXPECT_LT(largest_difference(layers, truth), 0.03)
        << wall_z;  // the edge profile's 0.02, and what it takes one place for
    EXPECT_LT(rms_difference(passes, truth), 0.005) << wall_z;
    EXPECT_LT(rms_difference(layers, truth), 0.008) << wall_z;
  }
}

TEST(PredictedPictures, WhatThePostHidesIsFoundAndNotGuessed) {
  // A light right behind a post that the pupil sees round, just as wide: no sharp view shows it.
  const auto lit = [](double x, double) { return std::abs(x) < 0.024 ? 5.0 : 0.5; };
  const FlatScene scene({{-0.5, -0.006, 0.006, -9.0, 9.0, [](double, double) { return 0.1; }}, wall(-2.0, lit)});
  const SightField field(picture(40, 8), Eye::with(Prescription{}, 2e-2, FixedAccommodation{0.5, 2.0}), std::nullopt);
  const Image truth = brute_force(scene, field);
  EXPECT_GT(truth.at(20, 4)[0], 0.55f);
  const Image passes = by_passes(scene, field, 256), layers = by_layers(scene, field);
  EXPECT_LT(largest_difference(passes, truth), 5.0 * 0.02);
  EXPECT_LT(largest_difference(layers, truth), 4.9 * 2 * 0.02);  // two edges, 0.02 each
}

TEST(PredictedPictures, SameBitsForAnyNumberOfThreads) {
  const FlatScene scene = post_before_a_wall(-3.0);
  const SightField field(picture(40, 24, Gaze::Foveal),
                         Eye::with(Prescription{-0.5, -1.0, 20.0, 0.0}, 1e-2, BestAccommodation{2.0}), std::nullopt);
  const auto pictures = [&](int threads) {
    std::vector<float> all;
    tbb::task_arena(threads).execute([&] {
      for (const Image& image : {by_passes(scene, field, 24), by_layers(scene, field)})
        all.insert(all.end(), image.pixels.begin(), image.pixels.end());
    });
    return all;
  };
  EXPECT_EQ(pictures(1), pictures(3));
}

TEST(PredictedPictures, AnEyeThatAccommodatesEverywhereSeesEverythingSharp) {
  const FlatScene scene = post_before_a_wall(-3.0);
  const SightField best(picture(40, 24, Gaze::Foveal), Eye::with(Prescription{}, 1e-2, BestAccommodation{10.0}),
                        std::nullopt);
  const SightField pinhole(picture(40, 24, Gaze::Foveal), Eye::with(Prescription{}, 0.0), std::nullopt);
  const Image sharp = by_passes(scene, pinhole, 256), seen = by_passes(scene, best, 256);
  for (int y = 0; y < 24; ++y)
    for (const int x : {2, 8, 20, 32, 37})  // off the edges, where the gaze jumps between post and wall within a pixel
      EXPECT_NEAR(seen.at(x, y)[0], sharp.at(x, y)[0], 0.01) << x;
}

TEST(PredictedPictures, RefusesAViewThatDoesNotCoverThePicture) {
  const FlatScene scene = post_before_a_wall(-2.0);
  const SightField field(picture(12, 10), Eye::with(Prescription{}, 4e-3), std::nullopt);
  const FragmentImage view = scene.sharp_view(field);
  EXPECT_THROW(predict_by_passes(view, 2, field, scene.first_hits(), scene.shader()), std::invalid_argument);
  EXPECT_THROW(predict_by_layers(view, 2, field, {}), std::invalid_argument);
}

}  // namespace
}  // namespace sturm
