#include "experiments/stress/report.h"

#include <nlohmann/json.hpp>

#include "io/files/formatted_text.h"
#include "io/json/values.h"
#include "lensmodel/units.h"

namespace sturm::stress {

namespace {

std::string skipped_text(const CheckSummary& c) {
  std::string text;
  for (std::size_t i = 1; i < skips.size(); ++i)
    if (c.skipped[i] > 0)
      text += (text.empty() ? "" : ", ") + std::string(skips[i]) + " " + std::to_string(c.skipped[i]);
  return text.empty() ? "-" : text;
}

Json worst_json(double value, std::uint64_t index, std::uint64_t run) {
  return {{"value", number_or_null(value)}, {"case", run > 0 && value > 0.0 ? Json(index) : Json(nullptr)}};
}

using ExtendedMatrix = std::array<std::array<Extended, 2>, 2>;

/// 21 digits as text: a JSON number is read as a double.
std::string digits(Extended x) {
  return formatted("%.21Lg", x);
}
Json digits(const ExtendedMatrix& m) {
  return Json::array(
      {Json::array({digits(m[0][0]), digits(m[0][1])}), Json::array({digits(m[1][0]), digits(m[1][1])})});
}
Json digits(const Vec3<Extended>& v) {
  return Json::array({digits(v.x), digits(v.y), digits(v.z)});
}

Json double_json(const CaseRun& run) {
  Json j = {{"status", run.conoid ? name_of(run.conoid->status) : "ok"}};
  if (!run.footprint) return j;
  if (run.conoid) {
    j["chief_ray"] = {{"origin_m", json_of(run.conoid->chief_ray.origin)},
                      {"direction", json_of(run.conoid->chief_ray.direction)}};
  }
  j["accommodation_D"] = number_or_null(run.footprint->accommodation_D);
  j["angular_footprint"] = rows_json(run.footprint->angular);
  j["wavefront_curvature_D"] =
      run.footprint->wavefront_curvature ? symmetric_json(*run.footprint->wavefront_curvature) : Json(nullptr);
  return j;
}

Json extended_json(const CaseRun& run) {
  if (!run.oracle) return nullptr;
  const ExtendedTrace& t = *run.oracle;
  Json j = {{"status", name_of(t.status)}, {"surfaces", Json::array()}};
  for (int i = 0; i < t.crossings; ++i) {
    const Crossing& c = t.at[static_cast<std::size_t>(i)];
    j["surfaces"].push_back(
        {{"path_m", c.path_m}, {"cos_in", c.cos_in}, {"radicand", c.radicand}, {"x_m", c.x}, {"y_m", c.y}});
  }
  if (t.status != LensStatus::ok || !run.footprint) return j;
  const Eigen::Matrix2d slopes = run.eye->slope_matrix(run.footprint->accommodation_D).matrix();
  j["chief_ray"] = {{"origin_m", digits(t.exit_point)}, {"direction", digits(t.direction)}};
  j["angular_footprint"] = digits(t.angular_footprint(slopes, vergence_of(run.numbers.distance_m)));
  const auto k = t.exit_curvature(slopes);
  j["wavefront_curvature_D"] = k ? digits(*k) : Json(nullptr);
  const ErrorBounds& b = *run.bounds;
  j["bounds"] = {{"exit_point_m", number_or_null(b.exit_point)}, {"direction", number_or_null(b.direction)},
                 {"offset_p", number_or_null(b.offset_p)},       {"offset_q_m", number_or_null(b.offset_q)},
                 {"slope_p_D", number_or_null(b.slope_p)},       {"slope_q", number_or_null(b.slope_q)}};
  return j;
}

const char* family_name(Family family) {
  return families[static_cast<std::size_t>(family)].name;
}

}  // namespace

std::string table_of(const SuiteSummary& s) {
  std::string text = formatted("%-15s %10s %8s %12s %10s %12s %10s  %s\n", "check", "cases", "over", "worst/bound",
                               "case", "worst rel.", "case", "skipped");
  for (std::size_t i = 0; i < check_count; ++i) {
    const CheckSummary& c = s.checks[i];
    text += formatted("%-15s %10llu %8llu %12.3g %10llu %12.3g %10llu  ", checks[i].name,
                      static_cast<unsigned long long>(c.run), static_cast<unsigned long long>(c.over), c.worst_ratio,
                      static_cast<unsigned long long>(c.worst_case), c.worst_relative,
                      static_cast<unsigned long long>(c.worst_relative_case)) +
            skipped_text(c) + "\n";
  }
  text += formatted("\n%-20s %10s %8s %10s %10s %10s %10s %8s\n", "family", "cases", "refused", "ok", "missed",
                    "reflected", "no conv.", "failed");
  for (std::size_t i = 0; i < families.size(); ++i) {
    const FamilySummary& f = s.families[i];
    text += formatted("%-20s %10llu %8llu %10llu %10llu %10llu %10llu %8llu\n", families[i].name,
                      static_cast<unsigned long long>(f.cases), static_cast<unsigned long long>(f.refused),
                      static_cast<unsigned long long>(f.statuses[0]), static_cast<unsigned long long>(f.statuses[1]),
                      static_cast<unsigned long long>(f.statuses[2]), static_cast<unsigned long long>(f.statuses[3]),
                      static_cast<unsigned long long>(f.failed));
  }
  text += formatted("\neq. 11 of the published form has no solution in %llu of %llu cases\n",
                    static_cast<unsigned long long>(s.published_failed),
                    static_cast<unsigned long long>(s.published_tried));
  text += formatted("%s: %llu of %llu cases failed (seed %llu)\n", s.passed() ? "PASSED" : "FAILED",
                    static_cast<unsigned long long>(s.failed), static_cast<unsigned long long>(s.options.cases),
                    static_cast<unsigned long long>(s.options.seed));
  return text;
}

Json report_of(const SuiteSummary& s) {
  Json check_list = Json::array(), family_list = Json::array();
  for (std::size_t i = 0; i < check_count; ++i) {
    const CheckSummary& c = s.checks[i];
    Json skipped = Json::object();
    for (std::size_t k = 1; k < skips.size(); ++k) skipped[skips[k]] = c.skipped[k];
    check_list.push_back({{"check", checks[i].name},
                          {"meaning", checks[i].meaning},
                          {"cases", c.run},
                          {"over_bound", c.over},
                          {"skipped", std::move(skipped)},
                          {"worst_of_bound", worst_json(c.worst_ratio, c.worst_case, c.run)},
                          {"worst_relative", worst_json(c.worst_relative, c.worst_relative_case, c.run)}});
  }
  for (std::size_t i = 0; i < families.size(); ++i) {
    const FamilySummary& f = s.families[i];
    family_list.push_back({{"family", families[i].name},
                           {"share", families[i].share},
                           {"cases", f.cases},
                           {"refused", f.refused},
                           {"ok", f.statuses[0]},
                           {"missed_lens", f.statuses[1]},
                           {"total_internal_reflection", f.statuses[2]},
                           {"no_convergence", f.statuses[3]},
                           {"failed", f.failed}});
  }
  return {{"format", "sturm.stress_report/1"},
          {"cases", s.options.cases},
          {"seed", s.options.seed},
          {"passed", s.passed()},
          {"failed_cases", s.failed},
          {"first_failed_cases", s.first_failed},
          {"formula_error", formula_error},
          {"checks", std::move(check_list)},
          {"families", std::move(family_list)},
          {"published", {{"cases", s.published_tried}, {"without_solution", s.published_failed}}}};
}

Json case_json(std::uint64_t seed, std::uint64_t index, const CaseRun& run, const FreeFormLenses& free_forms) {
  Json list = Json::array();
  for (std::size_t i = 0; i < check_count; ++i) {
    const Outcome& o = run.outcomes.all()[i];
    if (o.ran)
      list.push_back({{"check", checks[i].name},
                      {"passed", o.ratio <= 1.0},
                      {"of_bound", number_or_null(o.ratio)},
                      {"relative_error", number_or_null(o.relative)}});
    else
      list.push_back({{"check", checks[i].name}, {"skipped", skips[static_cast<std::size_t>(o.skip)]}});
  }
  Json j = {{"seed", seed},
            {"case", index},
            {"family", family_name(run.numbers.family)},
            {"passed", run.outcomes.passed()},
            {"query", query_json(run.numbers, free_forms)},
            {"refused", !run.eye},
            {"double", run.eye ? double_json(run) : Json(nullptr)},
            {"extended", extended_json(run)},
            {"checks", std::move(list)}};
  if (run.numbers.lens && run.numbers.lens->free_form)
    if (const auto& table = free_forms.table(*run.numbers.lens->free_form)) j["tables"] = {{table->file, table->text}};
  if (!run.thrown.empty()) j["thrown"] = run.thrown;
  return j;
}

}  // namespace sturm::stress
