#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "compare/studies/lens/lens_study_errors.h"
#include "compare/studies/lens/lens_study_views.h"
#include "experiments/lens_study/lens_study.h"

namespace sturm {

namespace {

constexpr OwnMutation mutations[] = {
    {"published_as_exact", "eq. 11 is passed off as the exact first order in the fit of the order"},
    {"mirrored_gaze", "the footprint is traced for the gaze mirrored left to right; the real rays are not"}};

/// Orders in the oblique views through analytic surfaces.
std::vector<double> oblique_orders(const LensFindings& found) {
  std::vector<double> orders;
  const std::set<std::string> splines = spline_lenses(found);
  for (const LensStudyView& view : found.views) {
    const bool oblique = view.eccentricity_deg.value_or(0.0) > 0.0;
    if (view.order && oblique && !splines.contains(view.lens)) orders.push_back(*view.order);
  }
  return orders;
}

/// Largest error [D] of ray transfer over all views and pupils.
double worst_defocus(const LensFindings& found) {
  double worst = 0.0;
  for (const LensStudyView& view : found.views)
    for (const LensPupil& pupil : view.pupils) worst = std::max(worst, defocus_of(pupil.ray_transfer).value_or(0.0));
  return worst;
}

double worst_first_order(const LensFindings& found, std::optional<FirstOrderError> FirstOrderErrors::*method) {
  double worst = 0.0;
  for (const LensStudyView& view : found.views)
    worst = std::max(worst, defocus_of(view.first_order.*method).value_or(0.0));
  return worst;
}

}  // namespace

LensStudyConditions conditions_of(const LensStudySpec& spec) {
  return {.radial = spec.quadrature.radial,
          .azimuthal = spec.quadrature.azimuthal,
          .order_pupils_mm = {1e3 * spec.order_small_m, 1e3 * spec.order_large_m},
          .rotation_center_mm = 1e3 * spec.rotation_center_m};
}

std::span<const OwnMutation> lens_study_mutations() {
  return mutations;
}

LensFindings mutated_lens_study(LensFindings found, const std::string& mutation) {
  const auto order = mutation == mutations[0].id   ? &MutantOrders::published_as_exact
                     : mutation == mutations[1].id ? &MutantOrders::mirrored_gaze
                                                   : nullptr;
  if (order)
    for (LensStudyView& view : found.views)
      if (view.mutant_orders.*order) view.order = view.mutant_orders.*order;
  return found;
}

Json lens_study_sentence(const LensFindings& found) {
  if (found.views.empty()) return nullptr;
  const std::vector<double> orders = oblique_orders(found);
  char order_text[96] = "";  // a single pupil has no order
  if (!orders.empty()) {
    const auto [lowest, highest] = std::minmax_element(orders.begin(), orders.end());
    std::snprintf(order_text, sizeof order_text, "falls with the pupil to the power %.2f to %.2f and ", *lowest,
                  *highest);
  }
  std::size_t traced = 0, failed = 0;
  for (const LensGaze& gaze : found.gazes) {
    const std::string word = gaze.eq11 ? gaze.eq11->principal : "";
    traced += !word.empty();
    failed += !word.empty() && word != "ok" && word != "free_axes";
  }
  char text[768];
  std::snprintf(text, sizeof text,
                "Through %zu lenses in %zu views, exact first order (ray transfer) differs from real rays by its "
                "truncation alone, which %sis at most %.2g D at the widest pupil; at every pupil alike, eq. 11 as "
                "published errs by "
                "up to %.2g D in first order "
                "(no solution in %zu of %zu gazes) and the previous method by up to %.2g D.",
                found.lenses.size(), found.views.size(), order_text, worst_defocus(found),
                worst_first_order(found, &FirstOrderErrors::published), failed, traced,
                worst_first_order(found, &FirstOrderErrors::previous));
  return text;
}

}  // namespace sturm
