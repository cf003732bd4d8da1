#include "compare/findings/lens_study.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compare/studies/lens/lens_study_errors.h"
#include "compare/studies/lens/lens_study_views.h"
#include "io/files/formatted_text.h"

namespace sturm {

namespace {

constexpr const char* order_deviation = "distance of the order of the absolute error from 4, oblique views";
constexpr const char* relative_order_deviation = "distance of the order of the relative error from 2, oblique views";
constexpr const char* limit_relative = "real rays at the pupil 0 against ray transfer";
constexpr const char* spline_order = "order of the relative error through a spline surface";
constexpr const char* revolution_error = "first-order error where eq. 11 is exact [D]";
constexpr const char* unscaled_error = "first-order error with the true magnification";
constexpr const char* largest_error = "largest first-order error of a lens [D]";

Number distance_from(const Number& value, double expected) {
  return value ? Number(std::abs(*value - expected)) : std::nullopt;
}

void add(const std::string& subject, const char* model, const char* quantity, const Number& value, Measurements& out) {
  out.push_back({.section = "lens_study", .subject = subject, .model = model, .quantity = quantity, .value = value});
}

/// Orders of convergence, which gates judge.
void add_orders(const LensFindings& found, Measurements& out) {
  const std::set<std::string> splines = spline_lenses(found);
  for (const LensStudyView& view : found.views) {
    const std::string name = view_name(view);
    const bool oblique = view.eccentricity_deg.value_or(1.0) > 0.0,
               blurred = view.blur_D[0].value_or(1.0) >= least_blur_D;
    if (splines.contains(view.lens)) {
      if (oblique && blurred) add(name, "ray_transfer", spline_order, view.relative_order, out);
      continue;
    }
    if (oblique) add(name, "ray_transfer", order_deviation, distance_from(view.order, 4.0), out);
    if (oblique && blurred)
      add(name, "ray_transfer", relative_order_deviation, distance_from(view.relative_order, 2.0), out);
    if (blurred) add(name, "ray_transfer", limit_relative, view.limit_relative, out);
  }
}

/// The largest first-order error of a method in the views of one lens; views where it has none are left out: they are
/// counted elsewhere.
Number largest_first_order_error(const LensFindings& found, const std::string& lens,
                                 std::optional<FirstOrderError> FirstOrderErrors::*method) {
  Extreme largest;
  for (const LensStudyView& view : found.views)
    if (view.lens == lens)
      if (const Number error = defocus_of(view.first_order.*method)) largest.add(error, view_name(view));
  return largest.result().value;
}

/// Errors of the other methods, which gates judge.
void add_methods(const LensFindings& found, Measurements& out) {
  const auto largest = [&](const LensFacts& lens, std::optional<FirstOrderError> FirstOrderErrors::*method) {
    return largest_first_order_error(found, lens.id, method);
  };
  for (const LensFacts& lens : found.lenses) {
    const bool round_lens = lens.lens_of_revolution.value_or(false);
    const bool round_eye = lens.cylinder_D.value_or(1.0) == 0.0;
    for (const LensStudyView& view : found.views) {
      if (view.lens != lens.id) continue;
      const bool on_axis = view.eccentricity_deg.value_or(1.0) == 0.0;
      if (round_lens && (on_axis || round_eye))
        add(view_name(view), "published", revolution_error, defocus_of(view.first_order.published), out);
      add(view_name(view), "previous", unscaled_error, view.previous_unscaled_error, out);
    }
    if (!round_eye) add(lens.id, "published", largest_error, largest(lens, &FirstOrderErrors::published), out);
    add(lens.id, "previous", largest_error, largest(lens, &FirstOrderErrors::previous), out);
  }
}

/// What another run of the same experiment has, too.
void add_compared(const LensFindings& found, Measurements& out) {
  for (const LensStudyView& view : found.views) {
    std::string name = "lens study " + view.lens;
    for (const Number& number : {view.eccentricity_deg, view.direction_deg, view.finite_distance_m()})
      name += "|" + (number ? plain_number(*number) : std::string());
    if (view.distance_m && view.distance_m->is_infinite()) name += "inf";
    const auto compare = [&](const char* quantity, const Number& value) {
      add(view_name(view), "ray_transfer", quantity, value, out);
      out.back().run_name = name + ": " + quantity;
    };
    compare("order", view.order);
    compare("relative_order", view.relative_order);
    compare("limit_relative", view.limit_relative);
  }
}

/// The views of one lens at all pupils, by one method.
struct Tally {
  std::optional<double> worst_D;
  std::string where;
  std::size_t ellipses = 0, matter = 0, without = 0;
};

void count(const LensStudyView& view, const LensPupil& pupil, const StudyMethod& method, Tally& tally) {
  const Number error = defocus_of(pupil.*method.error);
  if (!error) {
    ++tally.without;
    return;
  }
  ++tally.ellipses;
  if (*error > defocus_that_matters_D) ++tally.matter;
  if (tally.worst_D && *error <= *tally.worst_D) return;
  tally.worst_D = error;
  const std::string name = view_name(view);
  tally.where = name.substr(std::min(name.size(), view.lens.size() + 1)) +
                (pupil.pupil_mm ? ", pupil " + plain_number(*pupil.pupil_mm) + " mm" : std::string());
}

std::string measure_of(const Tally& tally) {
  std::string text = "largest error from real rays [D]";
  if (!tally.where.empty()) text += " (" + tally.where + ")";
  text += "; above " + plain_number(defocus_that_matters_D) + " D in " + std::to_string(tally.matter) + " of " +
          std::to_string(tally.ellipses) + " views and pupils";
  return tally.without > 0 ? text + "; none in " + std::to_string(tally.without) : text;
}

/// Rows of the table of cases: per lens and method the largest error against real rays over all its views and pupils,
/// and in how many of them it matters to a wearer.
void add_rows(const LensFindings& found, Measurements& out) {
  std::map<std::pair<std::string, std::string>, Tally> tallies;
  for (const LensStudyView& view : found.views)
    for (const LensPupil& pupil : view.pupils)
      for (const StudyMethod& method : study_methods) count(view, pupil, method, tallies[{view.lens, method.key}]);
  for (const LensFacts& lens : found.lenses)
    for (const StudyMethod& method : study_methods) {
      const Tally& tally = tallies[{lens.id, method.key}];
      add(lens.id, method.key, measure_of(tally).c_str(), tally.worst_D, out);
      out.back().listed_as = !tally.worst_D                            ? CaseStatus::NoResult
                             : *tally.worst_D > defocus_that_matters_D ? CaseStatus::Differs
                                                                       : CaseStatus::Agrees;
    }
}

}  // namespace

void measure_lens_study(const Json& report, Measurements& out) {
  const LensFindings found = lens_findings(report).value_or(LensFindings{});
  add_orders(found, out);
  add_methods(found, out);
  add_compared(found, out);
  add_rows(found, out);
}

std::span<const StatisticRule> lens_study_rules() {
  using Of = Extreme::Of;
  static constexpr const char* section = "lens_study";
  static constexpr StatisticRule rules[] = {
      {"lens_order_max_deviation", section, order_deviation, "ray_transfer"},
      {"lens_relative_order_max_deviation", section, relative_order_deviation, "ray_transfer"},
      {"lens_limit_max_relative", section, limit_relative, "ray_transfer"},
      {"lens_spline_relative_order_min", section, spline_order, "ray_transfer", Of::Smallest},
      {"lens_published_revolution_max_D", section, revolution_error, "published"},
      {"lens_published_min_of_largest_D", section, largest_error, "published", Of::Smallest},
      {"lens_previous_unscaled_max", section, unscaled_error, "previous"},
      {"lens_previous_min_of_largest_D", section, largest_error, "previous", Of::Smallest},
  };
  return rules;
}

}  // namespace sturm
