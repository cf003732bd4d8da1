#pragma once
#include <array>
#include <span>
#include <vector>

#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// What linear interpolation between pixels takes from a surface, one row of pixels after the other. Where light is
/// shared out linearly among pixels, a kernel is wider than its rays by 1/6 px² along each axis; a surface that has
/// 1/12 of its second differences taken away before makes up for that. A step from one plateau to another lies between
/// pixels and is interpolated exactly, so it stays. Differences across edges do not count, and no pair of pixels
/// exchanges more than a quarter of the darker one, so that light is kept and none is negative.
class LayerDetail {
 public:
  /// Of the columns from `left` up to `right` of an image of 3 channels, from the row `top` on; `coverage` may be
  /// empty. Keeps references.
  LayerDetail(const Image& radiance, std::span<const double> vergence_D, std::span<const float> coverage, double jump_D,
              int left, int right, int top);
  /// Of the whole image.
  LayerDetail(const Image& radiance, std::span<const double> vergence_D, std::span<const float> coverage, double jump_D)
      : LayerDetail(radiance, vergence_D, coverage, jump_D, 0, radiance.width, 0) {}

  /// What is to be added to the colours of the next row; holds until the next call. 0 where nothing is covered.
  std::span<const Detail> next_row();

 private:
  using Values = std::vector<float>;  // one for each pixel and colour of a row

  bool same_surface(std::size_t a, std::size_t b) const;
  void join_down(int y);
  void give_down(int y);
  void give_right(int y);
  const float* colours(int x, int y) const;
  std::size_t index(int x, int y) const;

  const Image& radiance_;
  std::span<const double> vergence_D_;
  std::span<const float> coverage_;
  double jump_D_;
  int left_, right_, y_;
  std::array<Values, 3> joined_down_;            // rows y − 1, y and y + 1 with the next ones, by y modulo 3
  std::array<Values, 2> given_down_;             // by the next row, of the rows y − 1 and y
  Values colours_, joined_right_, given_right_;  // of the row y, with a rim of two pixels on either side
  std::vector<Detail> detail_;                   // of the row y
};

}  // namespace sturm
