#pragma once
#include <Eigen/Core>
#include <span>

#include "wavefront/psf/spread_kernel.h"

namespace sturm {

/// Where a ray lands: pixels to the right and down of the point's own pixel.
struct LandedRay {
  Eigen::Vector2d place;
  double weight;
};

/// How the light of a ray falls on pixels.
enum class RayShare {
  FourPixels,  ///< on the four about its place
  OnePixel     ///< on the one that it lands in
};

/// The kernel that rays draw, summing to 1. A ray of a whole pixel is shared among the four pixels about its place: the
/// picture between the middles of its pixels is interpolated linearly. That keeps the mean of the rays and gives no
/// negative weight. (Kernels that share by Keys' cubic convolution are three times further from the truth where hard
/// edges lie between pixels, and ring about lamps.) Throws std::invalid_argument beyond the largest radius.
SpreadKernel deposited(std::span<const LandedRay> rays, int largest_radius_px, RayShare share = RayShare::FourPixels);

}  // namespace sturm
