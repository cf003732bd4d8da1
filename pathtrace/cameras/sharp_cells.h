#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "lensmodel/eye.h"
#include "pathtrace/cameras/camera_pose.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm {

/// Vergences 1/d [D] at which a blur stays below a bound: an interval, as the blur is a norm of a matrix that is affine
/// in the vergence.
struct SharpVergences {
  double farthest, nearest;  ///< ends; the first may be negative: then infinity is sharp as well

  bool empty() const { return nearest < std::max(0.0, farthest); }
};

/// `largest_blur` is a semi-axis as a slope [rad].
SharpVergences sharp_vergences(const Eye& eye, double accommodation_D, double largest_blur);

/// Where in a picture nothing is blurred by more than a bound, whatever is seen there: square cells of the picture.
/// Immutable once made.
class SharpCells {
 public:
  static constexpr int cell_px = 8;

  /// All cells sharp.
  SharpCells(int width, int height);

  bool at(int x, int y) const {
    return sharp_[static_cast<std::size_t>(y / cell_px) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(x / cell_px)] != 0;
  }
  bool any() const { return left_ > 0; }
  std::uint64_t pixels() const;  ///< in sharp cells

  /// Marks the cells that meet the rectangle [low, high] of picture coordinates [px] as blurred.
  void blur(const Eigen::Vector2d& low, const Eigen::Vector2d& high);

 private:
  int width_, height_, columns_, rows_;
  std::size_t left_;  // sharp cells
  std::vector<std::uint8_t> sharp_;
};

/// The sharp cells of the naked eye's picture in `camera` gaze, or null where there are none.
///
/// A ray through the pupil point p of a pixel at the chief slope q meets what lies at the planar depth d where the
/// chief ray of slope u = q + V(d) p, V(d) = I/d + F − A·I, would meet it
/// (docs/theory.md#4-the-footprint-of-the-pupil). So a triangle can be met from those pixels only whose distance from
/// its outline in the picture is at most a·|V(d)|, |V| the larger singular value, for the depths d that it has. Depths
/// with a·|V(d)| ≤ `largest_blur_px` form an interval; what a primitive has in front of and behind that interval blurs
/// the cells that its outline, widened by its own blur, meets. In the cells that are left every ray meets what it meets
/// within `largest_blur_px` of where the ray through the pupil's centre would: no occlusion is assumed, so hidden
/// things count too and the bound holds in any case. A picture around the scene is at infinity; a surrounding colour
/// looks the same from everywhere. Single precision of the rays aside.
///
/// What it does to a pixel, a box-filtered mean over a square of the picture: a straight edge of contrast C that
/// crosses the pixel changes it by at most √2·C·`largest_blur_px`.
///
/// For ray models whose slope is S p, S with the eigenvalues of F − A·I or between them: power_matrix, thin_lens,
/// sin2_radial.
std::shared_ptr<const SharpCells> sharp_cells(const SceneDescription& scene, const CameraPose& pose, const Eye& eye,
                                              double accommodation_D, double largest_blur_px);

}  // namespace sturm
