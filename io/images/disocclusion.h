#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// A guess at a surface point that the sharp view does not show because something nearer hides it.
struct HiddenSample {
  int x, y;           ///< pixel of the sharp view
  double vergence_D;  ///< 1/planar depth
  std::array<float, 3> rgb;
};

/// Continues far surfaces under the edges of nearer ones, so that a blurred edge has something to become transparent
/// to.
///
/// An edge is where the vergence of neighbouring pixels differs by more than `jump_D`. From there the far surface grows
/// inwards, pixel ring by pixel ring, by averaging what is known around (its first ring from unmixed pixels beyond the
/// edge), as far as blur can show it: `reach_px(near) + reach_px(far)` pixels, where `reach_px` gives the semi-major
/// axis of the blur at a vergence. One hidden surface per pixel; its texture, shading and end behind the object are
/// guesses, which is what limits this predictor. Rows of the result ascend, and columns within a row. `vergence_D` has
/// one value per pixel of `radiance`, row by row.
std::vector<HiddenSample> extrapolate_hidden(const Image& radiance, const std::vector<double>& vergence_D,
                                             double jump_D, const std::function<double(double)>& reach_px);

/// The same where the edges are known already: `edges` is what `depth_edges` (depth_edges.h) finds.
std::vector<HiddenSample> extrapolate_hidden(const Image& radiance, const std::vector<double>& vergence_D,
                                             double jump_D, std::span<const std::size_t> edges,
                                             const std::function<double(double)>& reach_px);

}  // namespace sturm
