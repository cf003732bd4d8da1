#pragma once
#include <optional>

namespace sturm {

/// Variance of an estimate, and the degrees of freedom that it was found with; none: it is as good as known.
struct EstimatedVariance {
  double variance = 0.0;
  std::optional<double> degrees;
};

/// The difference of two independent estimates as a normal deviate: Welch's t with Satterthwaite's degrees of freedom,
/// turned into the normal deviate of the same tail probability. The sum of the variances must be positive.
double welch_z(double difference, const EstimatedVariance& a, const EstimatedVariance& b);

}  // namespace sturm
