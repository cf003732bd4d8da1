#include "compare/metrics/ciede2000.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "compare/metrics/colour_spaces.h"
#include "compare/metrics/comparable.h"
#include "io/images/tone_map.h"

namespace sturm {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

double seventh_power_share(double chroma) {
  const double c7 = std::pow(chroma, 7), c25 = 6103515625.0;  // 25⁷
  return std::sqrt(c7 / (c7 + c25));
}

/// [0, 2π); 0 for grey.
double hue(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.0;
  const double h = std::atan2(b, a);
  return h < 0.0 ? h + 2.0 * std::numbers::pi : h;
}

struct LightnessChromaHue {
  double lightness, chroma, hue;
};

/// Differences and means of two colours in the corrected L' C' h'; equation numbers of [Sharma2005].
struct Step {
  double lightness, chroma, hue;                 ///< ΔL', ΔC', ΔH' (eqs. 8, 9, 11)
  double mean_lightness, mean_chroma, mean_hue;  ///< (eqs. 12 – 14)
};

Step step_between(const LightnessChromaHue& p, const LightnessChromaHue& q) {
  constexpr double half_turn = std::numbers::pi;
  const bool grey = p.chroma * q.chroma == 0.0;
  double turn = grey ? 0.0 : q.hue - p.hue;  // eq. 10
  if (turn > half_turn) turn -= 2.0 * half_turn;
  if (turn < -half_turn) turn += 2.0 * half_turn;
  double mean_hue = p.hue + q.hue;
  if (!grey) {
    if (std::abs(p.hue - q.hue) > half_turn)
      mean_hue += mean_hue < 2.0 * half_turn ? 2.0 * half_turn : -2.0 * half_turn;
    mean_hue *= 0.5;
  }
  return {q.lightness - p.lightness,
          q.chroma - p.chroma,
          2.0 * std::sqrt(p.chroma * q.chroma) * std::sin(0.5 * turn),
          0.5 * (p.lightness + q.lightness),
          0.5 * (p.chroma + q.chroma),
          mean_hue};
}

double weighted_length(const Step& s) {
  const double h = s.mean_hue;
  const double t = 1.0 - 0.17 * std::cos(h - 30.0 * degree) + 0.24 * std::cos(2.0 * h) +
                   0.32 * std::cos(3.0 * h + 6.0 * degree) - 0.20 * std::cos(4.0 * h - 63.0 * degree);  // eq. 15
  const double middle = s.mean_lightness - 50.0;
  const double s_l = 1.0 + 0.015 * middle * middle / std::sqrt(20.0 + middle * middle);  // eqs. 18 – 20
  const double s_c = 1.0 + 0.045 * s.mean_chroma, s_h = 1.0 + 0.015 * s.mean_chroma * t;
  const double blue = (h / degree - 275.0) / 25.0;
  const double rotation =
      -std::sin(60.0 * degree * std::exp(-blue * blue)) * 2.0 * seventh_power_share(s.mean_chroma);  // eqs. 16, 17, 21
  const double l = s.lightness / s_l, c = s.chroma / s_c, d = s.hue / s_h;
  return std::sqrt(l * l + c * c + d * d + rotation * c * d);  // eq. 22
}

Lab lab_of_display(const float* pixel) {
  const Colour lab =
      lab_of_xyz(xyz_of_light({srgb_to_linear(pixel[0]), srgb_to_linear(pixel[1]), srgb_to_linear(pixel[2])}));
  return {lab[0], lab[1], lab[2]};
}

}  // namespace

double ciede2000_difference(const Lab& first, const Lab& second) {
  const double mean_chroma = 0.5 * (std::hypot(first[1], first[2]) + std::hypot(second[1], second[2]));
  const double stretch = 1.0 + 0.5 * (1.0 - seventh_power_share(mean_chroma));  // 1 + G, eqs. 3 – 5
  const auto corrected = [&](const Lab& lab) {
    const double a = stretch * lab[1];
    return LightnessChromaHue{lab[0], std::hypot(a, lab[2]), hue(a, lab[2])};  // eqs. 6, 7
  };
  return weighted_length(step_between(corrected(first), corrected(second)));
}

Ciede2000 ciede2000(const Image& test, const Image& reference) {
  require_colour_pair(test, reference);
  Ciede2000 result;
  result.map = Image(test.width, test.height, 1);
  std::vector<double> row_sums(test.height);
  tbb::parallel_for(0, test.height, [&](int y) {
    for (int x = 0; x < test.width; ++x) {
      const float *p = test.at(x, y), *q = reference.at(x, y);
      // Equal pixels are common (black, clipped) and exactly 0.
      const bool equal = p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
      const double difference = equal ? 0.0 : ciede2000_difference(lab_of_display(p), lab_of_display(q));
      *result.map.at(x, y) = static_cast<float>(difference);
      row_sums[y] += difference;
    }
  });
  result.mean =
      std::accumulate(row_sums.begin(), row_sums.end(), 0.0) / (static_cast<double>(test.width) * test.height);
  return result;
}

}  // namespace sturm
