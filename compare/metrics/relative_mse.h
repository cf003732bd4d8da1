#pragma once
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// Mean of (x − r)²/(r² + 0.01) over pixels and channels, the usual measure of Monte Carlo noise in linear light, plain
/// and trimmed.
struct RelativeMse {
  double plain = 0.0;
  double trimmed =
      0.0;  ///< without the worst 0.1 % of the pixels (rounded down; a pixel counts with the mean of its channels)
};

/// Throws InputError as `require_comparable`.
RelativeMse relative_mse(const Image& test, const Image& reference);

/// Mean without the largest 0.1 % of the values (rounded down); 0 for none.
double trimmed_mean(std::vector<double> values);

}  // namespace sturm
