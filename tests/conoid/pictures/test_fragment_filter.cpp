#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "conoid/pictures/fragment_filter.h"
#include "support/a_trous_noise.h"

namespace sturm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// Uniform in [−1, 1), variance 1/3.
class Noise {
 public:
  float next() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<float>(state_ >> 8) / 8388608.0f - 1.0f;
  }

 private:
  std::uint32_t state_ = 12345;
};

/// What a fragment receives directly and indirectly, the noise added to either (half the width of a uniform density),
/// and its albedo.
struct Received {
  float direct, indirect, direct_noise, indirect_noise, albedo = 0.5f;
};

/// Two planes that meet in the middle of the view.
template <class ReceivedAt>
FragmentImage two_planes(int size, const ReceivedAt& received_at) {
  FragmentImage view{size, size, {0}, {}};
  Noise noise;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const bool left = x < size / 2;
      const Received r = received_at(x, y);
      Fragment f{};
      f.position = {0.01f * static_cast<float>(x - size / 2), 0.01f * static_cast<float>(y),
                    left ? -1.0f : -1.0f + 0.01f * static_cast<float>(x - size / 2)};
      f.normal = left ? Vector3f(0.0f, 0.0f, 1.0f) : Vector3f(-0.70710678f, 0.0f, 0.70710678f);
      f.albedo = Vector3f::Constant(r.albedo);
      f.direct = Vector3f::Constant(r.albedo * (r.direct + r.direct_noise * noise.next()));
      f.radiance = f.direct + Vector3f::Constant(r.albedo * (r.indirect + r.indirect_noise * noise.next()));
      f.direct_variance = Vector3f::Constant(r.albedo * r.albedo * r.direct_noise * r.direct_noise / 3.0f);
      f.indirect_variance = Vector3f::Constant(r.albedo * r.albedo * r.indirect_noise * r.indirect_noise / 3.0f);
      f.share = 1.0f;
      f.lambertian = true;
      view.fragments.push_back(f);
      view.first.push_back(static_cast<std::uint32_t>(view.fragments.size()));
    }
  return view;
}

/// 1 left and 3 right, a chequered albedo left.
FragmentImage bright_and_dark(int size, float direct_noise, float indirect_noise) {
  return two_planes(size, [&](int x, int) {
    const bool left = x < size / 2;
    return Received{left ? 0.6f : 1.8f, left ? 0.4f : 1.2f, direct_noise, indirect_noise,
                    left ? (x % 2 ? 0.8f : 0.4f) : 0.5f};
  });
}

FragmentImage smooth_of(const FragmentImage& view, const FilterSettings& settings = {}) {
  return filtered(view, 0.01, Vector3d::Zero(), settings);
}

double direct_of(const Fragment& f) {
  return static_cast<double>(f.direct.x() / f.albedo.x());
}
double indirect_of(const Fragment& f) {
  return static_cast<double>((f.radiance.x() - f.direct.x()) / f.albedo.x());
}

TEST(FragmentFilter, LeavesWhatHasNoNoise) {
  const FragmentImage view = bright_and_dark(32, 0.0f, 0.0f), smooth = smooth_of(view);
  for (std::size_t i = 0; i < view.fragments.size(); ++i)
    EXPECT_NEAR(smooth.fragments[i].radiance.x(), view.fragments[i].radiance.x(), 1e-5f);
}

/// Parts of the variances of direct and indirect light that the filter leaves, away from the crease and the borders.
struct Left {
  double direct, indirect;
};
Left noise_left(const FilterSettings& settings) {
  constexpr int size = 200, border = 14;
  const FragmentImage view = bright_and_dark(size, 0.3f, 0.2f), smooth = smooth_of(view, settings);
  double before[2] = {}, after[2] = {};
  for (int y = border; y < size - border; ++y)
    for (int x = border; x < size - border; ++x) {
      if (std::abs(x - size / 2) < border) continue;
      const double scale = x < size / 2 ? 1.0 : 3.0;
      const auto square = [scale](double value, double truth) { return std::pow(value - scale * truth, 2); };
      before[0] += square(direct_of(view.at(x, y)[0]), 0.6);
      after[0] += square(direct_of(smooth.at(x, y)[0]), 0.6);
      before[1] += square(indirect_of(view.at(x, y)[0]), 0.4);
      after[1] += square(indirect_of(smooth.at(x, y)[0]), 0.4);
    }
  return {after[0] / before[0], after[1] / before[1]};
}

constexpr double measured_pixels = 172.0 * (172.0 - 27.0);  // of noise_left
const FilterSettings without_edge_stopping{1, 1e3, 1e3};

TEST(FragmentFilter, VarianceFallsAsTheKernelsNormSays) {
  FilterSettings settings = without_edge_stopping;
  for (settings.levels = 1; settings.levels <= 3; ++settings.levels) {
    const double norm = testing::squared_norm(settings.levels), expected = norm * norm;
    const Left left = noise_left(settings);
    // Of neighbours that are correlated over 1/norm pixels each way: 4σ of the χ² of the independent ones.
    const double tolerance = 4.0 * std::sqrt(2.0 / (measured_pixels * expected));
    EXPECT_NEAR(left.direct / expected, 1.0, tolerance) << settings.levels;
    EXPECT_NEAR(left.indirect / expected, 1.0, tolerance) << settings.levels;
  }
}

TEST(FragmentFilter, SaysWhatIsLeftOfTheVariance) {
  const FragmentImage view = bright_and_dark(32, 0.3f, 0.2f), smooth = smooth_of(view, without_edge_stopping);
  const double norm = testing::squared_norm(1);
  const Fragment &raw = view.at(8, 16)[0], &f = smooth.at(8, 16)[0];
  EXPECT_NEAR(f.direct_variance.x() / raw.direct_variance.x(), norm * norm, 1e-5);  // 25 taps in float
  EXPECT_NEAR(f.indirect_variance.x() / raw.indirect_variance.x(), norm * norm, 1e-5);
}

/// (1 − x/4)⁴ for x = d²/tolerance², d in standard deviations.
double left_at(double tolerance) {
  return testing::left_by_falloff(
      [tolerance](double d2) { return std::pow(std::max(0.0, 1.0 - d2 / (4.0 * tolerance * tolerance)), 4); });
}

TEST(FragmentFilter, TolerancesLeaveWhatTheirWidthSays) {
  const double relative = 4.0 * std::sqrt(2.0 / (measured_pixels * 0.0748));
  for (const double tolerance : {1.5, 2.5, 5.0}) {
    const Left left = noise_left({1, tolerance, 1.6 * tolerance});
    EXPECT_NEAR(left.direct / left_at(tolerance), 1.0, relative) << tolerance;
    EXPECT_NEAR(left.indirect / left_at(1.6 * tolerance), 1.0, relative) << tolerance;
  }
}

TEST(FragmentFilter, TakesNoiseAndKeepsTexturesAndCreases) {
  const FragmentImage view = bright_and_dark(48, 0.2f, 0.2f), smooth = smooth_of(view);
  double before = 0.0, after = 0.0, left = 0.0;
  for (int y = 8; y < 40; ++y)
    for (int x = 8; x < 40; ++x) {
      const Fragment &raw = view.at(x, y)[0], &f = smooth.at(x, y)[0];
      const double truth = x < 24 ? 1.0 : 3.0;
      before += std::pow(static_cast<double>(raw.radiance.x() / raw.albedo.x()) - truth, 2);
      after += std::pow(static_cast<double>(f.radiance.x() / f.albedo.x()) - truth, 2);
      if (x < 24) left += static_cast<double>(f.radiance.x() / f.albedo.x()) / (16 * 32);
    }
  // One level alone leaves that share of the direct light's (TolerancesLeaveWhatTheirWidthSays), and less of the rest;
  // further ones take more, also beside the crease, where there are fewer taps.
  EXPECT_LT(after, left_at(FilterSettings{}.direct_tolerance) * before);
  EXPECT_NEAR(left, 1.0, 0.03);  // nothing of the bright plane: 0.28/√3/√512 = 0.007 of noise
}

TEST(FragmentFilter, AShadowsEdgeIsKeptWhateverTheNoiseOfIndirectLight) {
  // Direct light of 1 and 0.4 with little noise; indirect light whose noise is as large as that step: were it one, it
  // would hide it.
  const FragmentImage view = two_planes(64, [](int x, int) {
    return Received{x < 16 ? 1.0f : 0.4f, 0.5f, 0.02f, 0.6f};
  });
  const FragmentImage smooth = smooth_of(view);
  double noise = 0.0;
  for (int y = 8; y < 56; ++y) {
    // Seven standard errors of the noise before the filter: beyond that nothing may be mixed in.
    EXPECT_NEAR(direct_of(smooth.at(15, y)[0]), 1.0, 7.0 * 0.02 / std::sqrt(3.0));
    EXPECT_NEAR(direct_of(smooth.at(16, y)[0]), 0.4, 7.0 * 0.02 / std::sqrt(3.0));
    for (int x = 8; x < 24; ++x) noise += std::pow(indirect_of(smooth.at(x, y)[0]) - 0.5, 2) / (48 * 16);
  }
  EXPECT_LT(noise, left_at(FilterSettings{}.indirect_tolerance) * 0.6 * 0.6 / 3.0);
}

TEST(FragmentFilter, RareBrightSamplesKeepTheirLight) {
  // One pixel in 49 has all the light, and a variance that says so; the others have seen nothing and do not know of any
  // variance. The dark ones take much of what the bright ones lose: a half is left. If only a pixel's own variance
  // counted, it would be an eighth; the bound lies between.
  FragmentImage view = two_planes(70, [](int, int) { return Received{0.0f, 0.0f, 0.0f, 0.0f}; });
  for (int y = 3; y < 70; y += 7)
    for (int x = 3; x < 70; x += 7) {
      Fragment& f = view.fragments[static_cast<std::size_t>(y * 70 + x)];
      f.direct = f.radiance = Vector3f::Constant(1.0f);
      f.direct_variance = Vector3f::Constant(1.0f);
    }
  const FragmentImage smooth = smooth_of(view);
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < view.fragments.size(); ++i) {
    before += static_cast<double>(view.fragments[i].direct.x());
    after += static_cast<double>(smooth.fragments[i].direct.x());
  }
  EXPECT_GT(after, 0.25 * before);
}

TEST(FragmentFilter, AFragmentCountsByItsShare) {
  // In every other column a corner of each pixel, an eighth of it, is the surface: what it saw there counts for an
  // eighth.
  FragmentImage view = two_planes(32, [](int x, int) { return Received{x % 2 ? 0.0f : 1.0f, 0.0f, 0.0f, 0.0f}; });
  for (Fragment& f : view.fragments) {
    f.direct_variance = Vector3f::Constant(1.0f);
    if (!(f.direct.x() > 0.0f)) f.share = 0.125f;
  }
  // Taps on even columns add up to ½ of the kernel.
  EXPECT_NEAR(direct_of(smooth_of(view, without_edge_stopping).at(8, 16)[0]), 1.0 / 1.125, 1e-4);
}

TEST(FragmentFilter, NothingComesAcrossACrease) {
  // Whatever the other plane receives: right at the crease it is nearer than the tolerance of a plane, so that normals
  // have to tell.
  FragmentImage view = bright_and_dark(48, 0.3f, 0.3f);
  const FragmentImage smooth = smooth_of(view, without_edge_stopping);
  for (Fragment& f : view.fragments)
    if (f.position.x() >= 0.0f) f.radiance *= 7.0f, f.direct *= 7.0f;
  const FragmentImage other = smooth_of(view, without_edge_stopping);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 24; ++x) EXPECT_EQ(smooth.at(x, y)[0].radiance, other.at(x, y)[0].radiance) << x;
}

TEST(FragmentFilter, DoesNotTouchLampsAndSurroundings) {
  FragmentImage view = bright_and_dark(16, 0.3f, 0.3f);
  for (std::size_t i = 0; i < view.fragments.size(); i += 2) view.fragments[i].emits = true;
  for (std::size_t i = 1; i < view.fragments.size(); i += 2) view.fragments[i].surroundings = true;
  const FragmentImage smooth = smooth_of(view);
  for (std::size_t i = 0; i < view.fragments.size(); ++i)
    EXPECT_EQ(smooth.fragments[i].radiance, view.fragments[i].radiance);
}

TEST(FragmentFilter, GlossyFragmentsAreFilteredAsTheyAre) {
  // The same light on a chequered albedo, once divided by it and once not: of a glossy surface the light is the
  // radiance itself.
  FragmentImage view = bright_and_dark(48, 0.2f, 0.2f), plain = view;
  for (Fragment& f : view.fragments) f.lambertian = false;
  for (Fragment& f : plain.fragments) f.albedo.setOnes();
  for (std::size_t i = 0; i < view.fragments.size(); ++i) view.fragments[i].albedo.setConstant(0.3f);
  const FragmentImage smooth = smooth_of(view), expected = smooth_of(plain);
  for (std::size_t i = 0; i < view.fragments.size(); ++i)
    EXPECT_EQ(smooth.fragments[i].radiance, expected.fragments[i].radiance);
}

TEST(FragmentFilter, GlossyFragmentsOfAnotherAlbedoAndLambertianOnesStayOut) {
  // Columns in turn: glossy of one albedo, glossy of another, Lambertian. What the other two have makes no difference
  // to the first.
  const auto view_with = [](float others) {
    FragmentImage view = two_planes(36, [](int, int) { return Received{1.0f, 0.5f, 0.2f, 0.2f}; });
    for (std::size_t i = 0; i < view.fragments.size(); ++i) {
      Fragment& f = view.fragments[i];
      f.lambertian = i % 3 == 2;
      f.albedo.setConstant(i % 3 == 1 ? 0.37f : 0.3f);
      if (i % 3 != 0) f.direct *= others, f.radiance *= others;
    }
    return view;
  };
  const FragmentImage once = smooth_of(view_with(1.0f), without_edge_stopping),
                      often = smooth_of(view_with(5.0f), without_edge_stopping);
  for (std::size_t i = 0; i < once.fragments.size(); i += 3)
    EXPECT_EQ(once.fragments[i].radiance, often.fragments[i].radiance) << i;
}

}  // namespace
}  // namespace sturm
