#pragma once
#include <Eigen/Core>
#include <optional>

#include "io/images/image.h"

namespace sturm {

/// By how much `test` stands to the right of and below `reference` [px], as a whole: least squares of first order
/// [Lucas & Kanade 1981] over all pixels whose window lies inside,
///
///     t(x) − r(x) ≈ −∇m(x)·d + g·m(x),   m = (t + r)/2,
///
/// t and r the lumas, smoothed by a Gaussian of 2 px. The common gain g is fitted along, so that lost light is no
/// displacement. The gradient is that of the mean of both: white noise of either picture is uncorrelated with its own
/// central difference, and what noise adds to Σ ∇m ∇mᵀ makes d a little short, which the smoothing keeps below a
/// hundredth where the picture has structure. Good for displacements below the smoothing's width; blur that differs
/// between the two, and edges that move by parallax, are averaged over.
///
/// None for pictures without structure in both directions, or with fewer than 32 pixels along a side. Throws InputError
/// unless both have the same size, three channels and finite pixels.
std::optional<Eigen::Vector2d> displacement_px(const Image& test, const Image& reference);

}  // namespace sturm
