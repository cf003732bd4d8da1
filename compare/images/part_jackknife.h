#pragma once
#include <span>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// What the parts of a map (one channel) contribute to its mean; they add up to it. The map is cut into as many equal
/// rectangles as there is room for with sides of at least `least_side_px` (≥ 1), row by row.
std::vector<double> shares_of_mean(const Image& map, int least_side_px);

/// A standard error, and how well it is known.
struct PartError {
  double standard_error = 0.0;
  double degrees = 0.0;  ///< of freedom; 0 where the standard error is 0
};

/// Standard error of the mean of a map that is made of n ≥ 2 independent replicates: the jackknife [EfronStein1981] of
/// each part, added up. `left_out`: the parts' shares with each replicate left out in turn. Noise in one part tells
/// nothing of that in another where a pixel's random numbers are its own, so that k parts know their common error as
/// well as a jackknife of the mean would from k times as many replicates: Satterthwaite's degrees of freedom,
/// (Σvₖ)²/Σ(vₖ²/(n − 1)) of the parts' variances vₖ, which are too few rather than too many since the vₖ are noisy
/// themselves. Left out is what neighbouring parts have in common across their border: parts must be much wider than
/// what a map's value depends on.
PartError jackknife_by_parts(std::span<const std::vector<double>> left_out);

}  // namespace sturm
