#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "compare/studies/lens/lens_study_views.h"
#include "experiments/run/sections.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

constexpr double order_tolerance = 0.05;  // of the gates that the mutants must violate

/// Orders in the oblique views through analytic surfaces, as they stand at `path`.
std::vector<double> oblique_orders(const Json& section, const std::string& path) {
  std::vector<double> orders;
  const std::set<std::string> splines = spline_lenses(section);
  for (const Json& view : array_at(section, "views")) {
    const auto order = number_at(view, path);
    const bool oblique = number_at(view, "eccentricity_deg").value_or(0.0) > 0.0;
    if (order && oblique && !splines.contains(text_at(view, "lens"))) orders.push_back(*order);
  }
  return orders;
}

/// Largest |order − 4| of them; null where there is none.
Json worst_order_deviation(const Json& section, const std::string& path) {
  Json worst = nullptr;
  for (const double order : oblique_orders(section, path)) {
    const double deviation = std::abs(order - 4.0);
    if (worst.is_null() || deviation > worst.get<double>()) worst = deviation;
  }
  return worst;
}

Json mutant(const Json& section, const char* id, const char* what, const std::string& path) {
  const Json value = worst_order_deviation(section, path);
  const bool noticed = value.is_number() && value.get<double>() > order_tolerance;
  return {{"id", id}, {"what", what}, {"failed_as_it_must", noticed}, {"value", value}, {"bound", order_tolerance}};
}

/// Largest error [D] of a method over all views and pupils.
double worst_defocus(const Json& section, const std::string& method) {
  double worst = 0.0;
  for (const Json& view : array_at(section, "views"))
    for (const Json& pupil : array_at(view, "pupils"))
      worst = std::max(worst, number_at(pupil, method + "/defocus_D").value_or(0.0));
  return worst;
}

double worst_first_order(const Json& section, const std::string& method) {
  double worst = 0.0;
  for (const Json& view : array_at(section, "views"))
    worst = std::max(worst, number_at(view, "first_order/" + method + "/defocus_D").value_or(0.0));
  return worst;
}

}  // namespace

Json assembled_lens_study(const LensStudySpec& spec, const Json& parts, const Json& field) {
  Json section = {{"conditions",
                   {{"radial", spec.quadrature.radial},
                    {"azimuthal", spec.quadrature.azimuthal},
                    {"order_pupils_mm", {1e3 * spec.order_small_m, 1e3 * spec.order_large_m}},
                    {"rotation_center_mm", 1e3 * spec.rotation_center_m}}},
                  {"lenses", Json::array()},
                  {"gazes", Json::array()},
                  {"views", Json::array()},
                  {"field", field}};
  for (const Json& part : parts) {
    section["lenses"].push_back(part.at("lens"));
    for (const char* list : {"gazes", "views"})
      section[list].insert(section[list].end(), part.at(list).begin(), part.at(list).end());
  }
  return section;
}

Json lens_study_mutants(const Json& section) {
  return {
      mutant(section, "published_as_exact", "eq. 11 was passed off as the exact first order in the fit of the order",
             "mutant_orders/published_as_exact"),
      mutant(section, "mirrored_gaze",
             "the footprint was traced for the gaze mirrored left to right; the real rays were not",
             "mutant_orders/mirrored_gaze")};
}

Json lens_study_sentence(const Json& section) {
  if (section.is_null() || array_at(section, "views").empty()) return nullptr;
  const std::vector<double> orders = oblique_orders(section, "order");
  char order_text[64] = "–";
  if (!orders.empty()) {
    const auto [lowest, highest] = std::minmax_element(orders.begin(), orders.end());
    std::snprintf(order_text, sizeof order_text, "%.2f to %.2f", *lowest, *highest);
  }
  std::size_t traced = 0, failed = 0;
  for (const Json& gaze : array_at(section, "gazes")) {
    const std::string word = text_at(gaze, "eq11/principal");
    traced += !word.empty();
    failed += !word.empty() && word != "ok" && word != "free_axes";
  }
  char text[768];
  std::snprintf(text, sizeof text,
                "Through %zu lenses in %zu views, exact first order (ray transfer) differs from real rays by its "
                "truncation alone, which falls with "
                "the pupil to the "
                "power %s and is at most %.2g D at the widest pupil; at every pupil alike, eq. 11 as published errs by "
                "up to %.2g D in first order "
                "(no solution in %zu of %zu gazes) and the previous method by up to %.2g D.",
                array_at(section, "lenses").size(), array_at(section, "views").size(), order_text,
                worst_defocus(section, "ray_transfer"), worst_first_order(section, "published"), failed, traced,
                worst_first_order(section, "previous"));
  return text;
}

}  // namespace sturm
