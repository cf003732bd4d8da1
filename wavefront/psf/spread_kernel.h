#pragma once
#include <vector>

namespace sturm {

/// What a point of light in the middle of a pixel becomes on the pixels about it. Rows go from the top down, as in
/// `Image`: the light of pixel (x, y) that reaches pixel (x + dx, y + dy) is weight(dx, dy), |dx|, |dy| ≤ radius_px.
struct SpreadKernel {
  int radius_px = 0;
  std::vector<float> weights = {
      1};  ///< side() × side(), row by row; they sum to the share of the pupil's light that they stand for.
  double widening_px2 = 0.0;  ///< variance along either axis that sharing the light out among pixels has added

  int side() const { return 2 * radius_px + 1; }
  float weight(int dx, int dy) const { return weights[(dy + radius_px) * side() + dx + radius_px]; }
  float& weight(int dx, int dy) { return weights[(dy + radius_px) * side() + dx + radius_px]; }
  /// The sum of all weights, in double.
  double sum() const;
};

}  // namespace sturm
