#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "conoid/pictures/image_predictor.h"

namespace sturm {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double output_slope = 1e-3;  // of an output pixel

SharpView flat_view(int size, int margin, float depth, float radiance) {
  SharpView view;
  view.radiance = Image(size + 2 * margin, size + 2 * margin, 3);
  view.depth = Image(size + 2 * margin, size + 2 * margin, 1);
  view.margin_px = margin;
  view.pixel_slope = output_slope;
  for (float& v : view.radiance.pixels) v = radiance;
  for (float& v : view.depth.pixels) v = depth;
  return view;
}

/// Naked emmetrope whose blur at vergence v has the radius a|v − A|.
Eye emmetrope(double pupil_diameter_m) {
  return Eye::with(Prescription{}, pupil_diameter_m);
}

Eye astigmat(double sphere, double cylinder, double axis, double pupil_diameter_m) {
  return Eye::with(Prescription{sphere, cylinder, axis, 0.0}, pupil_diameter_m);
}

struct Moments {
  double mass = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;  // image coordinates in px, y *up*
};

Moments moments(const Image& image, int channel) {
  Moments m;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double w = image.at(x, y)[channel], up = image.height - 1 - y;
      m.mass += w, m.x += w * x, m.y += w * up;
      m.xx += w * x * x, m.xy += w * x * up, m.yy += w * up * up;
    }
  m.x /= m.mass, m.y /= m.mass;
  m.xx = m.xx / m.mass - m.x * m.x, m.xy = m.xy / m.mass - m.x * m.y, m.yy = m.yy / m.mass - m.y * m.y;
  return m;
}

TEST(ImagePredictor, ZeroPupilIsAnExactCopy) {
  SharpView view = flat_view(9, 2, 1.0f, 0.0f);
  std::mt19937 random(7);
  for (float& v : view.radiance.pixels)
    v = std::exp2(static_cast<float>(random() % 53) - 26.0f) * static_cast<float>(random() % 1000 + 1);
  for (float& v : view.depth.pixels) v = 0.1f * static_cast<float>(random() % 100 + 1);
  const Prediction p = predict_image(view, emmetrope(0.0), 0.0);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x)
      for (int c = 0; c < 3; ++c) EXPECT_EQ(p.radiance.at(x, y)[c], view.radiance.at(x + 2, y + 2)[c]);
  EXPECT_EQ(p.counters.splatted_pixels, 0);
  EXPECT_EQ(p.counters.sharp_pixels, 13 * 13);
  EXPECT_EQ(p.counters.clipped_radius_px, 0.0);
}

TEST(ImagePredictor, PlaneOfConstantDepthConservesTheSum) {
  SharpView view = flat_view(60, 12, 0.5f, 0.0f);  // blur radius 2e-3 · 2 / 1e-3 = 4 px
  double sum_in = 0.0;
  for (int y = 30; y < 50; ++y)
    for (int x = 30; x < 50; ++x) {
      view.radiance.at(x, y)[1] = static_cast<float>(x + 3 * y);
      sum_in += x + 3 * y;
    }
  const Prediction p = predict_image(view, emmetrope(4e-3), 0.0);
  double sum_out = 0.0;
  for (std::size_t i = 1; i < p.radiance.pixels.size(); i += 3) sum_out += p.radiance.pixels[i];
  EXPECT_NEAR(sum_out / sum_in, 1.0, 1e-6);  // float storage: 6e-8 per pixel
  EXPECT_EQ(p.counters.layers, 1);
  for (const float covered : p.coverage.pixels) EXPECT_NEAR(covered, 1.0f, 1e-6f);
}

TEST(ImagePredictor, ConstantImageStaysConstantWhateverTheDepths) {
  SharpView view = flat_view(40, 0, 1.0f, 0.7f);
  std::mt19937 random(3);
  for (float& v : view.depth.pixels) v = 0.3f + 0.01f * static_cast<float>(random() % 200);
  const Prediction p = predict_image(view, astigmat(-1.0, -2.0, 20.0, 6e-3), 0.0);
  for (const float value : p.radiance.pixels) EXPECT_NEAR(value, 0.7f, 1e-6f);  // float storage
}

struct PsfCase {
  double sphere, cylinder, axis, depth, accommodation;
};

class PointSpread : public ::testing::TestWithParam<PsfCase> {};

// Variance a²/4 V Vᵀ per pixel slope² and 1/12 px² for the output pixel, wearer frame (y up). Weights at pixel centres
// are samples of the ellipse convolved with the pixel box, which has a bounded spectrum only approximately: 0.03 px² is
// left for radii of >= 4 px.
TEST_P(PointSpread, HasTheCovarianceOfItsEllipse) {
  const PsfCase& t = GetParam();
  const double radius = 3e-3;
  SharpView view = flat_view(81, 40, static_cast<float>(t.depth), 0.0f);
  view.radiance.at(80, 80)[0] = 1.0f;
  const Prediction p = predict_image(view, astigmat(t.sphere, t.cylinder, t.axis, 2 * radius), t.accommodation);
  // Power in the wearer's frame from docs/theory.md#1-frames-signs-units alone: C acts along u, across the axis line at
  // 180° − AXIS.
  const double u = (180.0 - t.axis + 90.0) * std::numbers::pi / 180.0;
  const double isotropic = (std::isinf(t.depth) ? 0.0 : 1.0 / t.depth) + t.sphere - t.accommodation;
  Eigen::Matrix2d v;
  v << isotropic + t.cylinder * std::cos(u) * std::cos(u), t.cylinder * std::cos(u) * std::sin(u),
      t.cylinder * std::cos(u) * std::sin(u), isotropic + t.cylinder * std::sin(u) * std::sin(u);
  const Eigen::Matrix2d expected = radius * radius / 4.0 * v * v.transpose() / (output_slope * output_slope);
  const Moments m = moments(p.radiance, 0);
  EXPECT_NEAR(m.mass, 1.0, 1e-6);
  EXPECT_NEAR(m.x, 40.0, 1e-5);
  EXPECT_NEAR(m.y, 40.0, 1e-5);
  EXPECT_NEAR(m.xx, expected(0, 0) + 1.0 / 12.0, 0.03);
  EXPECT_NEAR(m.xy, expected(0, 1), 0.03);
  EXPECT_NEAR(m.yy, expected(1, 1) + 1.0 / 12.0, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Eyes, PointSpread,
                         ::testing::Values(PsfCase{-2.0, -3.0, 30.0, 1.0, 0.0}, PsfCase{-2.0, -3.0, 150.0, 1.0, 0.0},
                                           PsfCase{-4.0, 6.0, 80.0, 0.5, 0.0},
                                           PsfCase{1.0, 0.0, 180.0, std::numeric_limits<double>::infinity(), 4.0},
                                           PsfCase{-1.5, -2.0, 100.0, std::numeric_limits<double>::infinity(), 0.0}));

TEST(ImagePredictor, Axis30AndAxis150AreMirrorImages) {
  SharpView view = flat_view(41, 20, 1.0f, 0.0f);
  view.radiance.at(40, 40)[0] = 1.0f;
  // 1/d + F = 1 − 1 − 4 across the axis: a line along the axis has zero width; the light lies along u.
  const auto xy = [&](double axis) {
    return moments(predict_image(view, astigmat(-1.0, -4.0, axis, 6e-3), 0.0).radiance, 0).xy;
  };
  // The blur is 12 px long along u. AXIS 30: axis at 150° for the wearer, u at 60° or 240°: right-up, positive. cov =
  // 36 · sin 60° cos 60°.
  EXPECT_NEAR(xy(30.0), 15.588, 0.05);
  EXPECT_NEAR(xy(150.0), -15.588, 0.05);
}

TEST(ImagePredictor, NearSharpCardGetsNoLightFromTheFarBackground) {
  SharpView view = flat_view(60, 20, infinity, 100.0f);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 50; ++x) {
      view.depth.at(x, y)[0] = 0.5f;
      view.radiance.at(x, y)[0] = view.radiance.at(x, y)[1] = view.radiance.at(x, y)[2] = 1.0f;
    }
  const Prediction p =
      predict_image(view, emmetrope(4e-3), 2.0);  // focused on the card; the background has radius 4 px
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) EXPECT_EQ(p.radiance.at(x, y)[0], x < 30 ? 1.0f : 100.0f) << x;
}

/// A near card left of the middle before a wall in focus: the share of the wall on each column.
std::vector<double> wall_share_across_the_edge(int oversampling) {
  const int n = oversampling;
  SharpView view = flat_view(60 * n, 20 * n, 1.0f, 0.0f);
  view.oversampling = n;
  view.pixel_slope = output_slope / n;
  for (int y = 0; y < 100 * n; ++y)
    for (int x = 0; x < 100 * n; ++x) {
      const bool card = x < 50 * n;
      view.depth.at(x, y)[0] = card ? 0.25f : 1.0f;
      view.radiance.at(x, y)[0] = card ? 0.0f : 1.0f;
    }
  const Prediction p =
      predict_image(view, emmetrope(4e-3), 1.0);  // wall in focus; card blurred by 2e-3 · 3 / 1e-3 = 6 px
  std::vector<double> share;
  for (int x = 0; x < 60; ++x) share.push_back(p.radiance.at(x, 30)[0]);
  return share;
}

TEST(ImagePredictor, BlurredNearCardHasATransparentEdgeOfItsEllipsesWidth) {
  // The card's coverage across its edge is the disc's cumulative projected density; the wall shows through by the rest.
  const auto covered = [](double distance_px) {
    const double s = std::clamp(distance_px / 6.0, -1.0, 1.0);
    return 0.5 - (std::asin(s) + s * std::sqrt(1.0 - s * s)) / std::numbers::pi;
  };
  for (const int oversampling : {1, 2, 3}) {
    const auto share = wall_share_across_the_edge(oversampling);
    for (int x = 0; x < 60; ++x) {
      // Box-sampled both in the source and the output: the profile's curvature over a pixel, density' / 6 < 0.01.
      EXPECT_NEAR(share[x], 1.0 - covered(x + 0.5 - 30.0), 0.01) << x << " oversampling " << oversampling;
    }
    EXPECT_NEAR(share[23], 0.0, 1e-12);  // rounding of the kernel's sum
    EXPECT_NEAR(share[36], 1.0f, 1e-6);
  }
}

TEST(ImagePredictor, ObliquePlaneStaysCovered) {
  SharpView view = flat_view(80, 30, 1.0f, 0.5f);
  for (int y = 0; y < 140; ++y)
    for (int x = 0; x < 140; ++x)
      view.depth.at(x, y)[0] = static_cast<float>(1.0 / (0.5 + 0.02 * y));  // 0.06 px of blur per pixel
  const Prediction p = predict_image(view, emmetrope(6e-3), 1.0);
  EXPECT_GT(p.counters.layers, 10);
  EXPECT_EQ(p.counters.hidden_pixels, 0);
  // Coverage is the inverse Jacobian of the spreading, averaged over the pupil: 1 + O(gradient²) and layers of finite
  // number.
  for (const float covered : p.coverage.pixels) EXPECT_NEAR(covered, 1.0f, 0.01f);
}

TEST(ImagePredictor, OversamplingShrinksTheSharpPixelsShareOfTheBlur) {
  const auto variance = [](int n) {
    SharpView view = flat_view(41 * n, 20 * n, 0.5f, 0.0f);
    view.oversampling = n;
    view.pixel_slope = output_slope / n;
    for (int y = 40 * n; y < 41 * n; ++y)
      for (int x = 40 * n; x < 41 * n; ++x) view.radiance.at(x, y)[2] = 1.0f;  // one output pixel of light
    const Moments m = moments(predict_image(view, emmetrope(4e-3), 0.0).radiance, 2);
    EXPECT_NEAR(m.mass, 1.0, 1e-6);
    return m.xx;
  };
  // Disc of 4 px: 4 px². Output pixel 1/12; the source's square (1 − 1/n²)/12 as seen by its n² centres.
  for (const int n : {1, 2, 4}) EXPECT_NEAR(variance(n), 4.0 + 1.0 / 12.0 + (1.0 - 1.0 / (n * n)) / 12.0, 0.03) << n;
}

TEST(ImagePredictor, OversampledPixelsAreSpreadFromTheirOwnPlaces) {
  const int n = 3;
  const auto spread = [&](int x, int y) {  // sharp pixel (x, y) counted from the inner corner of the guard band
    SharpView view = flat_view(30 * n, 16, 0.5f, 0.0f);
    view.oversampling = n;
    view.pixel_slope = output_slope / n;
    view.radiance.at(16 + x, 16 + y)[0] = 1.0f;
    return predict_image(view, emmetrope(4e-3), 0.0).radiance;
  };
  const Moments m = moments(spread(46, 42), 0);
  // The disc of 4 px about (15.5, 14.1667); pixel quantisation of a smooth disc moves the mean by less than 0.01 px.
  EXPECT_NEAR(m.x + 0.5, 46.5 / 3.0, 0.01);
  EXPECT_NEAR(30.0 - m.y - 0.5, 42.5 / 3.0, 0.01);
  // The guard band is part of the same grid: a point there does what one 12 output pixels further in does.
  const Image outside = spread(-4, -2), inside = spread(-4 + 36, -2 + 36);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 6; ++x) EXPECT_EQ(outside.at(x, y)[0], inside.at(x + 12, y + 12)[0]) << x << ' ' << y;
  EXPECT_GT(outside.at(0, 0)[0], 0.0f);
}

TEST(ImagePredictor, DimPixelsSurviveBesideABrightOne) {
  SharpView view = flat_view(40, 10, 0.5f, 1e-8f);
  view.radiance.at(30, 30)[0] = 1e8f;
  const Prediction p = predict_image(view, emmetrope(4e-3), 0.0);
  EXPECT_NEAR(p.radiance.at(20 + 6, 20)[0] / 1e-8, 1.0, 1e-6);  // 2 px outside of the bright pixel's disc
  EXPECT_NEAR(p.radiance.at(20, 20)[0] / 1e8, 1.0 / (std::numbers::pi * 16.0), 1e-6);
}

SharpView noisy_room(int size, int margin) {
  SharpView view = flat_view(size, margin, 1.0f, 0.0f);
  std::mt19937 random(11);
  for (float& v : view.radiance.pixels) v = static_cast<float>(random() % 4096) / 512.0f;
  for (int y = 0; y < view.depth.height; ++y)
    for (int x = 0; x < view.depth.width; ++x) {
      const bool box = x > size / 3 && x < size / 2 && y > size / 4;
      view.depth.at(x, y)[0] = box ? 0.6f + 0.0007f * static_cast<float>(x) : 1.0f + 0.002f * static_cast<float>(y);
    }
  return view;
}

TEST(ImagePredictor, SameBitsForAnyNumberOfThreads) {
  const SharpView view = noisy_room(70, 10);
  const auto with_threads = [&](int n) {
    Prediction p;
    tbb::task_arena(n).execute([&] { p = predict_image(view, astigmat(-1.0, -1.5, 30.0, 5e-3), 0.3); });
    return p;
  };
  const Prediction one = with_threads(1), two = with_threads(2);
  EXPECT_EQ(one.radiance.pixels, two.radiance.pixels);
  EXPECT_EQ(one.coverage.pixels, two.coverage.pixels);
}

TEST(ImagePredictor, GuardBandIsTheLargestSemiAxisOfTheTwoEnds) {
  const Eye eye = astigmat(-1.0, -2.0, 30.0, 4e-3);  // −1 and −3 D
  EXPECT_EQ(required_margin_px(eye, 0.0, 1e-3, 0.5, std::numeric_limits<double>::infinity()),
            6);                                                 // 2 mm · 3 D at infinity
  EXPECT_EQ(required_margin_px(eye, 0.0, 1e-3, 0.1, 1.0), 18);  // 2 mm · (10 − 1) D
  EXPECT_EQ(required_margin_px(emmetrope(0.0), 0.0, 1e-3, 0.1, 1.0), 0);
  EXPECT_THROW(required_margin_px(eye, 0.0, 1e-3, 0.0, 1.0), std::invalid_argument);
}

TEST(ImagePredictor, SaysWhereTheGuardBandIsTooNarrow) {
  EXPECT_NEAR(predict_image(flat_view(20, 3, 0.5f, 1.0f), emmetrope(4e-3), 0.0).counters.clipped_radius_px, 4.0, 1e-9);
  EXPECT_EQ(predict_image(flat_view(20, 4, 0.5f, 1.0f), emmetrope(4e-3), 0.0).counters.clipped_radius_px, 0.0);
}

TEST(ImagePredictor, RefusesViewsThatDoNotFit) {
  const auto refused = [](auto change) {
    SharpView view = flat_view(8, 2, 1.0f, 1.0f);
    change(view);
    EXPECT_THROW(predict_image(view, emmetrope(4e-3), 0.0), std::invalid_argument);
  };
  refused([](SharpView& v) { v.depth = Image(3, 3, 1); });
  refused([](SharpView& v) { v.margin_px = 6; });
  refused([](SharpView& v) { v.oversampling = 3; });
  refused([](SharpView& v) { v.pixel_slope = 0.0; });
  refused([](SharpView& v) { v.depth.pixels[5] = std::numeric_limits<float>::quiet_NaN(); });
  refused([](SharpView& v) { v.depth.pixels[5] = 0.0f; });
  refused([](SharpView& v) { v.depth.pixels[5] = 1e-30f; });
  refused([](SharpView& v) { v.radiance.pixels[5] = infinity; });
}

RC_GTEST_PROP(ImagePredictor, StaysWithinTheRangeOfTheSharpView, ()) {
  const int size = *rc::gen::inRange(4, 24);
  SharpView view = flat_view(size, 4, 1.0f, 0.0f);
  for (float& v : view.radiance.pixels) v = static_cast<float>(*rc::gen::inRange(0, 1000));
  for (float& v : view.depth.pixels) v = 0.05f * static_cast<float>(*rc::gen::inRange(2, 60));
  const Eye eye = astigmat(*rc::gen::inRange(-30, 30) * 0.25, *rc::gen::inRange(-12, 13) * 0.25,
                           *rc::gen::inRange(1, 181), *rc::gen::inRange(0, 9) * 1e-3);
  const Prediction p = predict_image(view, eye, *rc::gen::inRange(0, 12) * 0.25);
  const auto [low, high] = std::minmax_element(view.radiance.pixels.begin(), view.radiance.pixels.end());
  for (const float value : p.radiance.pixels)
    RC_ASSERT(value >= *low * (1.0f - 1e-6f) && value <= *high * (1.0f + 1e-6f));
  for (const float covered : p.coverage.pixels) RC_ASSERT(covered > 0.0f && covered <= 1.0f + 1e-6f);
}

}  // namespace
}  // namespace sturm
