#pragma once
#include <span>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// Where the variance of a block's mean comes from.
enum class BlockVariance {
  /// From the block means of the replicates. Always right, but R replicates give only R − 1 degrees of freedom each.
  Replicates,
  /// From the scatter of every pixel between the replicates, added up over the block: hundreds of degrees of freedom
  /// even with two
  /// replicates.
  /// Only for images whose pixels are independent of each other (path traced, one sampler per pixel, box filter), not
  /// for filtered or
  /// predicted ones.
  IndependentPixels
};

struct BlockTestOptions {
  int block = 16;               ///< pixels; blocks at the right and lower edge may be smaller
  double family_level = 0.001;  ///< chance that two equal images are told apart by the largest |z|
  BlockVariance variance = BlockVariance::Replicates;
};

/// Do two images, each rendered several times with independent seeds, have the same expectation? Seen as such by
/// Welch's t test of the block means, with Satterthwaite's degrees of freedom.
struct BlockTest {
  Image z;  ///< blocks across × blocks down × channels: normal deviates of the same tail probability as t; positive
            ///< where a is brighter
  double threshold =
      0.0;  ///< on |z|, Šidák-corrected over all blocks and channels (conservative: channels share their paths)
  double z_max = 0.0;                               ///< largest |z|
  int worst_x = 0, worst_y = 0, worst_channel = 0;  ///< block indices of z_max

  /// Σ z² over the blocks of one channel against chi squared: finds a small difference that is everywhere. (One channel
  /// at a time, since the channels are not independent.)
  struct ChiSquared {
    double value, degrees, p;
  };
  std::vector<ChiSquared> chi_squared;

  /// Image mean of a over image mean of b per channel, with the standard error from the replicates; 0 ± 0 where b is
  /// black.
  struct Ratio {
    double value, standard_error;
  };
  std::vector<Ratio> mean_ratio;

  bool same() const { return z_max <= threshold; }
};

/// `a` and `b`: at least two replicates each, all of one size. Throws InputError otherwise and for non-finite pixels.
BlockTest block_test(std::span<const Image> a, std::span<const Image> b, const BlockTestOptions& options = {});

}  // namespace sturm
