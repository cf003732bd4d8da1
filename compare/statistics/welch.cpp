#include "compare/statistics/welch.h"

#include <cmath>

#include "compare/statistics/statistics.h"

namespace sturm {

namespace {

double satterthwaite_share(const EstimatedVariance& v) {
  return v.degrees ? v.variance * v.variance / *v.degrees : 0.0;
}

}  // namespace

double welch_z(double difference, const EstimatedVariance& a, const EstimatedVariance& b) {
  const double variance = a.variance + b.variance, t = difference / std::sqrt(variance);
  const double shares = satterthwaite_share(a) + satterthwaite_share(b);
  return shares > 0.0 ? normal_equivalent_of_t(t, variance * variance / shares) : t;
}

}  // namespace sturm
