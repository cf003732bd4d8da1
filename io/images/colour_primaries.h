#pragma once
#include <Eigen/Core>
#include <string>

#include "io/images/image.h"

namespace sturm {

/// CIE 1931 chromaticities (x, y) of red, green, blue and white: what the numbers of a picture mean as colours.
struct ColourPrimaries {
  Eigen::Vector2d red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06}, white{0.3127, 0.3290};  ///< Rec. 709, D65

  /// Whether they are Rec. 709's within the rounding that programs write them with (5e-4).
  bool is_rec709() const;

  /// "R (0.64, 0.33), G …"
  std::string text() const;
};

/// Linear Rec. 709 from linear RGB of other primaries: both through CIE XYZ [SMPTE RP 177], the whites adapted by
/// Bradford's transform [Lam 1985], so that white stays (1, 1, 1). Throws std::domain_error where the chromaticities
/// span no colours: a white or primary with y ≤ 0, primaries in a line, a white outside of their triangle.
Eigen::Matrix3d rec709_from(const ColourPrimaries& primaries);

/// The first three channels of every pixel times a matrix.
void transform_colours(Image& image, const Eigen::Matrix3d& matrix);

}  // namespace sturm
