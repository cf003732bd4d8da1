#pragma once
#include <Eigen/Core>
#include <vector>

namespace sturm {

/// How the light of one image point is shared among pixels when it is spread uniformly over an ellipse: the weight of a
/// pixel is exactly area(ellipse ∩ pixel box) / area(ellipse), in closed form. The weights sum to 1 to rounding (a few
/// 1e-16 per pixel).
///
/// The ellipse is the image of the unit disc, so an ellipse without width (a focal line) is the limit of thin ones: its
/// light lies on the line with the disc's projected density 2/π √(1 − s²). No floor width is needed. Memory and time
/// are O(perimeter).
class EllipseKernel {
 public:
  /// One row of pixels: edge weights for [begin, inner_begin) and [inner_end, end), the weight inner_weight() in
  /// between.
  struct Row {
    int begin, inner_begin, inner_end, end;  ///< columns relative to the source's pixel
    std::size_t edges;                       ///< first of this row's edge weights in edge_weights()
  };

  /// `map` takes the unit disc to image offsets [px]; x to the right, y down. `source` is where the point lies within
  /// its pixel, strictly inside (0, 1)² from the pixel's left top corner.
  EllipseKernel(const Eigen::Matrix2d& map, const Eigen::Vector2d& source);

  int first_row() const { return first_row_; }  ///< relative to the source's pixel
  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<double>& edge_weights() const { return edge_weights_; }
  double inner_weight() const { return inner_weight_; }

 private:
  int first_row_ = 0;
  std::vector<Row> rows_;
  std::vector<double> edge_weights_;
  double inner_weight_ = 0.0;
};

}  // namespace sturm
