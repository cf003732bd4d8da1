#pragma once
#include <vector>

#include "wavefront/layers/kernel_bank.h"
#include "wavefront/layers/spatial_blur.h"

namespace sturm {

/// How a layer is blurred within a tile.
enum class BlurMethod {
  Unblurred,  ///< its kernels hold one pixel
  Spatial,    ///< tap by tap
  Transform   ///< through the spectrum
};

/// What a picture is cut into, and what is cheaper where. Overlap-save: a tile is blurred with a rim of the largest
/// kernel radius, of which nothing is kept.
class BlurPlan {
 public:
  explicit BlurPlan(const KernelBank& bank);

  int side() const { return side_; }  ///< of a tile with its rim
  int rim() const { return rim_; }
  CellBox kept() const { return {rim_, rim_, side_ - rim_, side_ - rim_}; }

  /// For a layer whose light lies in `lit` of a tile, with `planes` of light and coverage to be blurred, and the same
  /// light for all parts of the pupil or another for each.
  BlurMethod method(int plane, const CellBox& lit, int planes, bool same_light) const;

  /// Whether a full tile would be blurred by transforms.
  bool transforms(int plane) const { return method(plane, {0, 0, side_, side_}, 4, true) == BlurMethod::Transform; }

 private:
  int side_, rim_, parts_;
  std::vector<int> radius_;
  std::vector<double> taps_;  // of all parts of a plane, in the channel that has most
};

}  // namespace sturm
