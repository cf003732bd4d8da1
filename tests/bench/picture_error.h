#pragma once
#include <vector>

#include "io/images/image.h"

namespace sturm::bench {

/// Error of a picture against a reference: the mean over pixels of (x − r)²/(r² + 0.01), itself the mean of the three
/// channels. Left out are pixels whose mean reference radiance exceeds 5 (they see an emitter or its disc) and of the
/// rest the worst 0.1 %, so that one firefly does not decide. The reference's own noise counts in full. Throws
/// std::invalid_argument for pictures of different size.
double trimmed_relative_error(const Image& picture, const Image& reference);

/// How two renderers' pictures of one view agree. Each side has at least two pictures with independent seeds.
struct Agreement {
  double mean_ratio[3];            ///< ours / theirs, over the whole picture, per channel
  double standard_error[3];        ///< of mean_ratio
  int blocks;                      ///< blocks of 16 × 16 pixels, times three channels
  double rms_z, largest_z;         ///< of the differences of block means over their standard errors; 1 = noise alone
  double largest_z_expected_0_01;  ///< what the largest exceeds with a probability of 1 % if all differences are noise
                                   ///< (Šidák)
};

/// A block's standard error comes from how the pictures of one side differ pixel by pixel (256 and more degrees of
/// freedom), which takes the noise of pixels as independent.
Agreement agreement(const std::vector<Image>& ours, const std::vector<Image>& theirs);

}  // namespace sturm::bench
