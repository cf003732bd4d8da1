#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/studies/sin2/summary.h"

namespace sturm {

namespace {

using Value = std::optional<double>;

/// The largest (or smallest) of a quantity over the cases that it is asked of, and where it is. One case without a
/// number leaves none.
class Worst {
 public:
  explicit Worst(bool smallest = false) : smallest_(smallest) {}

  void add(const StudyCase& c, const Value& value) {
    ++cases_;
    if (spoilt_) return;
    if (!value || !where_ || (smallest_ ? *value < *value_ : *value > *value_)) {
      spoilt_ = !value;
      value_ = value;
      where_ = &c;
    }
  }

  Sin2Check check(const Sin2StudySpec& spec) const {
    return {
        .value = value_, .cases = cases_, .worst_case = where_ ? std::optional(label_of(*where_, spec)) : std::nullopt};
  }

 private:
  bool smallest_, spoilt_ = false;
  std::int64_t cases_ = 0;
  Value value_;
  const StudyCase* where_ = nullptr;
};

using Asked = std::function<bool(const StudyCase&)>;
using Of = std::function<Value(const StudyCase&)>;

Of quantity(StudyQuantity q) {
  return [q](const StudyCase& c) { return c[q]; };
}

Of distance_from(StudyQuantity q, double expected) {
  return [q, expected](const StudyCase& c) { return c[q] ? Value(std::abs(*c[q] - expected)) : std::nullopt; };
}

Value quotient(const Value& a, const Value& b) {
  return a && b && *b > 0.0 ? Value(*a / *b) : std::nullopt;
}

Of ratio_off(StudyQuantity of, double expected) {
  return [of, expected](const StudyCase& c) {
    const Value ratio = quotient(c[of], c[StudyQuantity::true_major_arcmin]);
    return ratio ? Value(std::abs(*ratio - expected)) : std::nullopt;
  };
}

Asked ok(RayModel model) {
  return [model](const StudyCase& c) { return c.model == model && c.status == StudyStatus::ok; };
}

Asked both(Asked a, Asked b) {
  return [a = std::move(a), b = std::move(b)](const StudyCase& c) { return a(c) && b(c); };
}

/// |small| is nothing but rounding beside `large`.
bool vanishes(double small, double large) {
  return std::abs(small) <= 1e-9 * std::abs(large);
}

double principal_difference(const StudyCase& c) {
  return *c[StudyQuantity::high_D] - *c[StudyQuantity::low_D];
}

bool line_focus(const StudyCase& c) {
  const double high = *c[StudyQuantity::high_D], low = *c[StudyQuantity::low_D];
  return (high != 0.0 && vanishes(low, high)) || (low != 0.0 && vanishes(high, low));
}

bool circle_of_least_confusion(const StudyCase& c) {
  const double high = *c[StudyQuantity::high_D], low = *c[StudyQuantity::low_D];
  return high > 0.0 && vanishes(high + low, high);
}

bool has(const StudyCase& c, StudyQuantity q) {
  return c[q].has_value();
}

/// The sum of all samplings' checks: measured rms against √(E[r²]/(a²/2)).
void add_samplings(Sin2Checks& checks, const std::function<Sin2Check(const Asked&, const Of&, bool)>& worst,
                   const Sin2StudySpec& spec) {
  const auto measured = [](StudyQuantity q) {
    return [q](const StudyCase& c) { return c.status == StudyStatus::ok && has(c, q); };
  };
  const double rings = spec.rings.rings;
  const struct {
    const char* name;
    StudyQuantity q;
    double expected;
  } samplings[] = {{"polar_rms_max_deviation", StudyQuantity::polar_rms, std::sqrt(2.0 / 3.0)},
                   {"polar_weighted_rms_max_deviation", StudyQuantity::weighted_rms, 1.0},
                   {"rings_rms_max_deviation", StudyQuantity::rings_rms, std::sqrt((rings + 1.0) / rings)}};
  for (const auto& s : samplings) {
    // The poles of the printed formula make a pattern that few rays on a ring do not resolve.
    const Asked asked = both(measured(s.q), [](const StudyCase& c) { return c.model != RayModel::metalstigmatism; });
    checks[s.name] = worst(asked, distance_from(s.q, s.expected), false);
  }
}

}  // namespace

Sin2Checks study_checks(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases) {
  const auto worst = [&](const Asked& asked, const Of& value, bool smallest) {
    Worst w(smallest);
    for (const StudyCase& c : cases)
      if (asked(c)) w.add(c, value(c));
    return w.check(spec);
  };
  const Asked matrix = ok(RayModel::power_matrix), sin2 = ok(RayModel::sin2_radial),
              printed = ok(RayModel::metalstigmatism);
  const Asked astigmatic = both(sin2, [](const StudyCase& c) { return has(c, StudyQuantity::lost_variance_ratio); });
  const Asked round_eye = both(sin2, [](const StudyCase& c) { return !has(c, StudyQuantity::lost_variance_ratio); });
  const Of error_per_cylinder = [](const StudyCase& c) {
    return quotient(c[StudyQuantity::error_D], principal_difference(c));
  };
  Sin2Checks checks;
  checks["cases"] = {.value = static_cast<double>(cases.size()), .cases = static_cast<std::int64_t>(cases.size())};
  checks["matrix_vs_theory_max"] = worst(matrix, quantity(StudyQuantity::theory_deviation), false);
  checks["sin2_vs_closed_form_max"] = worst(sin2, quantity(StudyQuantity::closed_form_deviation), false);
  checks["metalstigmatism_vs_closed_form_max"] = worst(printed, quantity(StudyQuantity::closed_form_deviation), false);
  checks["sin2_radial_part_max_D"] = worst(sin2, quantity(StudyQuantity::radial_deviation_D), false);
  checks["sin2_without_cylinder_max"] = worst(round_eye, quantity(StudyQuantity::theory_deviation), false);
  checks["sin2_half_difference_max_deviation"] =
      worst(both(sin2, [](const StudyCase& c) { return has(c, StudyQuantity::difference_ratio); }),
            distance_from(StudyQuantity::difference_ratio, 0.5), false);
  checks["sin2_lost_variance_max_deviation"] =
      worst(astigmatic, distance_from(StudyQuantity::lost_variance_ratio, 1.0), false);
  checks["sin2_error_per_cylinder_min"] = worst(astigmatic, error_per_cylinder, true);
  checks["sin2_error_per_cylinder_max"] = worst(astigmatic, error_per_cylinder, false);
  checks["line_focus_length_max_deviation"] =
      worst(both(astigmatic, line_focus), ratio_off(StudyQuantity::major_arcmin, std::sqrt(5.0 / 8.0)), false);
  checks["line_focus_width_max_deviation"] =
      worst(both(astigmatic, line_focus), ratio_off(StudyQuantity::minor_arcmin, std::sqrt(1.0 / 8.0)), false);
  checks["circle_radius_max_deviation"] =
      worst(both(astigmatic, circle_of_least_confusion), ratio_off(StudyQuantity::major_arcmin, std::sqrt(0.5)), false);
  checks["repaired_vs_theory_max"] = worst(sin2, quantity(StudyQuantity::repaired_deviation), false);
  // Without any power the printed formula sends all rays out parallel, wherever the eye was to look.
  const Asked emmetrope = both(printed, [&](const StudyCase& c) {
    const Prescription& rx = spec.eyes[c.eye].prescription;
    const auto* fixed = std::get_if<FixedAccommodation>(&spec.accommodations[c.accommodation]);
    return rx.sphere_D == 0.0 && rx.cylinder_D == 0.0 && fixed &&
           fixed->focus_distance_m == spec.distances_m[c.distance] && std::isfinite(fixed->focus_distance_m);
  });
  checks["emmetrope_focused_at_infinity_max_deviation"] = worst(
      emmetrope,
      [&](const StudyCase& c) {
        return c[StudyQuantity::error_D]
                   ? Value(std::abs(*c[StudyQuantity::error_D] * spec.distances_m[c.distance] - 1.0))
                   : std::nullopt;
      },
      false);
  add_samplings(checks, worst, spec);
  const auto has_number = [](StudyQuantity q) { return [q](const StudyCase& c) { return has(c, q); }; };
  for (const StudyQuantity q : {StudyQuantity::mutant_repaired_as_sin2, StudyQuantity::mutant_wrong_coefficient,
                                StudyQuantity::mutant_mirrored_axis, StudyQuantity::mutant_sin2_as_matrix})
    checks[name_of(q)] = worst(has_number(q), quantity(q), false);
  return checks;
}

}  // namespace sturm
