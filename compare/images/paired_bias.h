#pragma once
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// By how much two estimators of one picture differ in their means, all pixels and channels together.
struct PairedBias {
  double mean_square = 0.0;     ///< unbiased: negative as often as positive where there is no difference. [radiance²]
  double standard_error = 0.0;  ///< of it, by the jackknife over the pairs (Efron & Stein 1981)
  double z = 0.0;               ///< mean_square over the error that it has where there is no difference
};

/// From R ≥ 3 independent pictures by each of both: with the differences d_i of the pairs, the products of *different*
/// pairs c_ij = ⟨d_i, d_j⟩, averaged over pixels and channels, have the mean |bias|², whatever the noise; mean_square
/// is their mean. Without a bias they are uncorrelated, so its error is their standard deviation over √(R(R − 1)/2),
/// and z is close to Student's t with R(R − 1)/2 − 1 degrees of freedom, since each c_ij sums over all pixels. The
/// jackknife's error is on the safe side. Throws std::invalid_argument for fewer pictures, or other numbers or sizes of
/// them.
PairedBias paired_bias(const std::vector<Image>& test, const std::vector<Image>& reference);

}  // namespace sturm
