#pragma once
#include "lensmodel/eye.h"
#include "wavefront/layers/kernel_model.h"

namespace sturm {

struct RayKernelSettings {
  int parts = 1;           ///< of the pupil
  bool chromatic = false;  ///< colours have kernels of their own: the Indiana eye at `primary_wavelengths_nm`
};

/// The kernels that rays through the pupil draw (docs/theory.md#143-pictures-with-depth): a point at vergence V lands
/// at −(V p + s(p) − A p) of its own place for the pupil point p, s = −∇W or F p, in the wearer frame. The rays are
/// those of a `RayFan`. `pixel_slope`: size of a pixel
/// in tangent units. Means are those of the rays; variances are, too, where a kernel is wider than a pixel. Throws
/// std::invalid_argument from `kernel` where a kernel exceeds `largest_kernel_radius_px`.
KernelModel ray_kernels(const Eye& eye, double accommodation_D, double pixel_slope, const RayKernelSettings& settings);

inline constexpr int largest_kernel_radius_px = 512;

}  // namespace sturm
