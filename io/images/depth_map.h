#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// What the numbers of a depth map are.
enum class DepthUnit { Metres, Millimetres, Dioptres, Disparity };

/// A rectified pair of cameras: a disparity of d pixels is a distance of f·b/(d + doffs) (Middlebury's formula).
struct StereoCalibration {
  double focal_px = 0.0, baseline_m = 0.0, doffs_px = 0.0;
};

struct DepthReading {
  /// None: metres, or millimetres of 16-bit files that state no scale.
  std::optional<DepthUnit> unit;
  std::optional<double> scale;  ///< factor of the stored numbers; 1 if none
  StereoCalibration stereo;     ///< for `Disparity`
};

/// Where a picture's surfaces are.
struct DepthMap {
  int width = 0, height = 0;
  std::vector<double> vergence_D;  ///< 1/planar distance, row by row; 0 is infinitely far
  long long filled_holes = 0;      ///< pixels that had no depth and got that of the farthest neighbour
};

/// Numbers as stored in one channel → vergences. Zero has no depth (a hole) but as dioptres, where it is infinitely
/// far; so have infinite disparities. Infinite distances are infinitely far. Holes get the vergence of their farthest
/// known neighbour, ring by ring, as what one camera does not see mostly belongs to the background. Throws InputError
/// about `name` for negative numbers, disparities that are negative with doffs added, NaN, and maps without any depth.
DepthMap depth_of(const Image& stored, const DepthReading& reading, const std::string& name);

/// Reads a depth map: EXR (channel Z, depth.Z, Y or the only one; else three equal ones), PFM, 16-bit PNG, and 8-bit
/// PNG if it is a disparity. Throws InputError, for other bit depths too.
DepthMap read_depth_map(const std::filesystem::path& path, const DepthReading& reading);

}  // namespace sturm
