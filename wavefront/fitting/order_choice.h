#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "wavefront/fitting/modal_fit.h"

namespace sturm {

/// How well one radial order predicts samples that it was not fitted to.
struct OrderTrial {
  int radial_order;
  int modes;
  double residual_rms;
  std::optional<double> left_out_rms;
};

struct OrderChoice {
  int radial_order;  ///< with the least left_out_rms
  std::vector<OrderTrial> trials;
};

inline constexpr int largest_tried_order = 10;

/// Tries the radial orders from 2 on for which there are no more modes than samples. All are measured on the same
/// samples, without those that are spurious for a fit of order 4 (or the largest below). Throws UndeterminedFit where
/// there is none.
OrderChoice choose_order(const std::function<ModalProblem(int radial_order)>& problem, int samples);

}  // namespace sturm
