#include "wavefront/fitting/order_choice.h"

#include <algorithm>
#include <string>

namespace sturm {

OrderChoice choose_order(const std::function<ModalProblem(int)>& problem, int samples) {
  constexpr int first_order = 2, judging_order = 4;
  int last = first_order - 1;
  while (last < largest_tried_order && static_cast<int>(problem(last + 1).modes.size()) <= samples) ++last;
  if (last < first_order)
    throw UndeterminedFit(std::to_string(samples) + " samples for " +
                          std::to_string(problem(first_order).modes.size()) + " modes of order 2");
  const std::vector<bool> used = fit_modes_robustly(problem(std::min(judging_order, last))).used;
  OrderChoice choice{first_order, {}};
  std::optional<double> least;
  for (int order = first_order; order <= last; ++order) {
    ModalFit fit;
    try {
      fit = fit_modes(problem(order), used);
    } catch (const UndeterminedFit&) {
      break;  // nor do the samples tell higher orders apart
    }
    choice.trials.push_back({order, static_cast<int>(fit.modes.size()), fit.residual_rms, fit.left_out_rms});
    if (fit.left_out_rms && (!least || *fit.left_out_rms < *least)) {
      least = fit.left_out_rms;
      choice.radial_order = order;
    }
  }
  if (choice.trials.empty()) throw UndeterminedFit("the points do not tell the modes of order 2 apart");
  return choice;
}

}  // namespace sturm
