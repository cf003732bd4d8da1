#include "compare/metrics/flip_filters.h"

#include <cmath>
#include <numbers>

namespace sturm {

namespace {

/// a·√(π/b)·exp(−π² r²/b), r in degrees: one Gaussian of a contrast sensitivity in the frequency domain, seen in space.
struct SensitivityTerm {
  double a, b;
};

const std::array<std::vector<SensitivityTerm>, 3> sensitivities{
    {{{1.0, 0.0047}}, {{1.0, 0.0053}}, {{34.1, 0.04}, {13.5, 0.025}}}};
constexpr double widest_b = 0.04;
constexpr double detector_width_deg = 0.082;  // peak to trough, twice the standard deviation

/// Weights exp(−x²/(2s²)) for x = −radius … radius.
std::vector<double> gaussian(double deviation_px, int radius) {
  std::vector<double> g;
  for (int x = -radius; x <= radius; ++x) g.push_back(std::exp(-0.5 * x * x / (deviation_px * deviation_px)));
  return g;
}

double sum_of(const std::vector<double>& weights) {
  double sum = 0.0;
  for (const double w : weights) sum += w;
  return sum;
}

std::vector<float> divided(const std::vector<double>& weights, double positive, double negative) {
  std::vector<float> result;
  for (const double w : weights)
    result.push_back(static_cast<float>(w == 0.0 ? 0.0 : w / (w > 0.0 ? positive : negative)));
  return result;
}

std::vector<float> with_unit_sums(const std::vector<double>& weights) {
  double positive = 0.0, negative = 0.0;
  for (const double w : weights) (w > 0.0 ? positive : negative) += std::abs(w);
  return divided(weights, positive, negative);
}

}  // namespace

std::array<GaussianSum, 3> contrast_filters(double pixels_per_degree) {
  const double pi = std::numbers::pi;
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(widest_b / (2.0 * pi * pi)) * pixels_per_degree));
  std::array<GaussianSum, 3> filters;
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<double> volumes;
    for (const auto& [a, b] : sensitivities[channel]) {
      const std::vector<double> g = gaussian(std::sqrt(b / (2.0 * pi * pi)) * pixels_per_degree, radius);
      const double sum = sum_of(g);
      volumes.push_back(a * std::sqrt(pi / b) * sum * sum);
      filters[channel].terms.push_back({0.0f, divided(g, sum, sum)});
    }
    const double total = sum_of(volumes);
    for (std::size_t i = 0; i < volumes.size(); ++i)
      filters[channel].terms[i].share = static_cast<float>(volumes[i] / total);
  }
  return filters;
}

FeatureFilters feature_filters(double pixels_per_degree) {
  // Below some 2 pixels per degree all of the Gaussian but the middle weight vanishes in double; the normalised filters
  // have the limits [1, 0, −1] and [½, −1, ½], which a deviation of a fifth of a pixel gives to 1e-5.
  const double deviation = std::max(0.2, 0.5 * detector_width_deg * pixels_per_degree);
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  const std::vector<double> g = gaussian(deviation, radius);
  std::vector<double> edge, point;
  for (int x = -radius; x <= radius; ++x) {
    edge.push_back(-x * g[x + radius]);
    point.push_back((x * x / (deviation * deviation) - 1.0) * g[x + radius]);
  }
  const double sum = sum_of(g);
  return {divided(g, sum, sum), with_unit_sums(edge), with_unit_sums(point)};
}

}  // namespace sturm
