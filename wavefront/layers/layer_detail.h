#pragma once
#include <span>

#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// What linear interpolation between pixels takes from a surface. Where light is shared out linearly among pixels, a
/// kernel is wider than its rays by 1/6 px² along each axis; a surface that has 1/12 of its second differences taken
/// away before makes up for that. A step from one plateau to another lies between pixels and is interpolated exactly,
/// so it stays. Differences across edges do not count, and no pair of pixels exchanges more than a quarter of the
/// darker one, so that light is kept and none is negative.
class LayerDetail {
 public:
  /// Of an image of 3 channels; `coverage` may be empty. Keeps references.
  LayerDetail(const Image& radiance, std::span<const double> vergence_D, std::span<const float> coverage, double jump_D)
      : radiance_(radiance), vergence_D_(vergence_D), coverage_(coverage), jump_D_(jump_D) {}

  /// What is to be added to the colour of a pixel.
  Detail at(int x, int y) const;

 private:
  /// The colour of the next pixel if it is of the same surface, else null.
  const float* neighbour(int x, int y, int dx, int dy) const;

  const Image& radiance_;
  std::span<const double> vergence_D_;
  std::span<const float> coverage_;
  double jump_D_;
};

/// Of all pixels of a picture, row by row.
std::vector<Detail> detail_of(const LayeredPicture& picture);

}  // namespace sturm
