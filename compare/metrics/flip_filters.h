#pragma once
#include <array>
#include <vector>

namespace sturm {

/// Σ share_i · G_i of normalised Gaussians G_i = weights_i ⊗ weights_i; the shares add up to 1.
struct GaussianSum {
  struct Term {
    float share;
    std::vector<float> weights;  ///< along x and along y; odd number, they add up to 1
  };
  std::vector<Term> terms;
};

/// FLIP's contrast sensitivities of the channels Y, Cx, Cz as filters in space [Andersson2020 §4.1.1, table 1].
std::array<GaussianSum, 3> contrast_filters(double pixels_per_degree);

/// FLIP's detectors [Andersson2020 §4.2]: first and second derivative of a Gaussian along one axis, smoothing along the
/// other. Positive weights add up to 1, negative ones to −1.
struct FeatureFilters {
  std::vector<float> smooth, edge, point;
};

FeatureFilters feature_filters(double pixels_per_degree);

}  // namespace sturm
