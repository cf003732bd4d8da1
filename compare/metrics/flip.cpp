#include "compare/metrics/flip.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "compare/metrics/colour_spaces.h"
#include "compare/metrics/comparable.h"
#include "compare/metrics/flip_filters.h"
#include "compare/metrics/separable_filter.h"
#include "io/images/tone_map.h"

namespace sturm {

namespace {

// Constants of [Andersson2020], sections 4.1 and 4.3.
constexpr float colour_exponent = 0.7f, feature_exponent = 0.5f;
constexpr float knee = 0.4f, knee_error = 0.95f;  // p_c and p_t: this share of the largest distance becomes this error

using Opponent = std::array<Image, 3>;  // Y, Cx, Cz, one channel each

Opponent opponent_planes(const Image& light) {
  Opponent planes;
  for (Image& p : planes) p = Image(light.width, light.height, 1);
  tbb::parallel_for(0, light.height, [&](int y) {
    for (int x = 0; x < light.width; ++x) {
      const float* p = light.at(x, y);
      const Colour c = opponent_of_xyz(xyz_of_light({p[0], p[1], p[2]}));
      for (int k = 0; k < 3; ++k) *planes[k].at(x, y) = c[k];
    }
  });
  return planes;
}

Image spread(const Image& plane, const GaussianSum& filter) {
  Image sum(plane.width, plane.height, 1);
  for (const GaussianSum::Term& term : filter.terms) {
    const Image part = filtered(plane, term.weights, term.weights);
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += term.share * part.pixels[i];
  }
  return sum;
}

/// L*a*b* whose chroma shrinks with lightness (Hunt effect).
Colour hunt_adjusted(const Colour& light) {
  const Colour lab = lab_of_xyz(xyz_of_light(light));
  return {lab[0], 0.01f * lab[0] * lab[1], 0.01f * lab[0] * lab[2]};
}

/// City-block between lightness and the Euclidean distance of the chromas [Abasi2020].
float hyab(const Colour& p, const Colour& q) {
  return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

Colour perceived(const Opponent& filtered, std::size_t i) {
  Colour light = light_of_xyz(xyz_of_opponent({filtered[0].pixels[i], filtered[1].pixels[i], filtered[2].pixels[i]}));
  for (float& v : light) v = std::clamp(v, 0.0f, 1.0f);
  return hunt_adjusted(light);
}

float redistributed(float distance, float largest) {
  const float error = std::pow(distance, colour_exponent), bend = knee * largest;
  return error < bend ? knee_error / bend * error
                      : knee_error + (error - bend) / (largest - bend) * (1.0f - knee_error);
}

/// Strength of edges or points: length of the responses along x and y.
struct Features {
  Image edges, points;
};

Image length_of(const Image& a, const Image& b) {
  Image result(a.width, a.height, 1);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) result.pixels[i] = std::hypot(a.pixels[i], b.pixels[i]);
  return result;
}

Features features_of(const Image& achromatic, const FeatureFilters& f) {
  constexpr std::array as_it_is{1.0f};
  Image y = achromatic;
  for (float& v : y.pixels) v = (v + 16.0f) / 116.0f;
  const Image smooth_x = filtered(y, f.smooth, as_it_is), smooth_y = filtered(y, as_it_is, f.smooth);
  return {length_of(filtered(smooth_y, f.edge, as_it_is), filtered(smooth_x, as_it_is, f.edge)),
          length_of(filtered(smooth_y, f.point, as_it_is), filtered(smooth_x, as_it_is, f.point))};
}

struct Seen {
  Opponent filtered;
  Features features;
};

Seen seen(const Image& light, double pixels_per_degree) {
  const Opponent planes = opponent_planes(light);
  const FeatureFilters filters = feature_filters(pixels_per_degree);
  const std::array<GaussianSum, 3> contrast = contrast_filters(pixels_per_degree);
  return {{spread(planes[0], contrast[0]), spread(planes[1], contrast[1]), spread(planes[2], contrast[2])},
          features_of(planes[0], filters)};
}

}  // namespace

Flip flip_of_light(const Image& test, const Image& reference, double pixels_per_degree) {
  require_colour_pair(test, reference);
  const Seen a = seen(clamped(test), pixels_per_degree), b = seen(clamped(reference), pixels_per_degree);
  const float largest =
      std::pow(hyab(hunt_adjusted({0.0f, 1.0f, 0.0f}), hunt_adjusted({0.0f, 0.0f, 1.0f})), colour_exponent);
  Flip result;
  result.map = Image(test.width, test.height, 1);
  std::vector<double> row_sums(test.height);
  tbb::parallel_for(0, test.height, [&](int y) {
    for (int x = 0; x < test.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * test.width + x;
      const float colour = redistributed(hyab(perceived(a.filtered, i), perceived(b.filtered, i)), largest);
      const float edge = std::abs(a.features.edges.pixels[i] - b.features.edges.pixels[i]);
      const float point = std::abs(a.features.points.pixels[i] - b.features.points.pixels[i]);
      const float feature = std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, feature_exponent);
      const float error = std::pow(colour, 1.0f - feature);
      result.map.pixels[i] = error;
      row_sums[y] += error;
    }
  });
  result.mean = std::accumulate(row_sums.begin(), row_sums.end(), 0.0) / static_cast<double>(result.map.pixels.size());
  return result;
}

int flip_window_px(double pixels_per_degree) {
  return static_cast<int>(
      contrast_filters(pixels_per_degree).front().terms.front().weights.size());  // the detectors are narrower
}

Flip flip(const Image& test, const Image& reference, double pixels_per_degree) {
  require_colour_pair(test, reference);
  return flip_of_light(srgb_to_linear(test), srgb_to_linear(reference), pixels_per_degree);
}

}  // namespace sturm
