#include "compare/findings/sin2_study.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/findings/measured.h"
#include "compare/studies/sin2/shown_checks.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

constexpr const char* rose = "total variation from theory ÷ that of two runs of theory, with a cylinder";
constexpr const char* over_noise = "total variation of the point spread from theory's ÷ that of two runs of theory";

/// Of numbers by quadrature, which have no noise, relative or of numbers below 1: the loosest bound that
/// configs/gates/sin2_study.json has on what is nothing but rounding, where a pole or a small difference of large
/// numbers costs digits.
constexpr double rounding = 1e-6;

/// So many standard errors of independent rays are taken for a bound on what the noise of as many low-discrepancy ones,
/// which scatter less, does to a radius; both reports have one, so independent rays would be 5.7 standard errors of the
/// difference apart.
constexpr double errors_of_a_bound = 4.0;

/// Total variation of two runs of one pattern over that of two others: between the seeds 1 … 6 and six views it
/// scatters from 0.90 to 1.21 (configs/gates/sin2_study.json), and patterns that are really others have above 100.
constexpr double same_pattern = 1.5;

/// A number by quadrature: nothing but rounding may change it.
Measurement exact(const std::string& subject, const std::string& model, const std::string& quantity,
                  const Number& value, const std::string& run_name) {
  return {.section = "sin2_study",
          .subject = subject,
          .model = model,
          .quantity = quantity,
          .value = value,
          .bound = rounding * std::max(1.0, std::abs(value.value_or(0.0))),
          .run_name = run_name};
}

/// A check is a statistic by itself.
void make_statistic(const Json& check, Measurement& m) {
  m.cases = static_cast<std::uint64_t>(number_at(check, "cases").value_or(0.0));
  m.worst_case = text_at(check, "worst_case");
  m.statistic = "sin2_study/" + m.subject;
}

/// Checks that gates judge and readers see: each names the case that decided.
void add_shown_checks(const Json& checks, Measurements& out) {
  for (const ShownCheck& shown : shown_checks) {
    const Json& check = value_at(checks, shown.key);
    const std::string worst = text_at(check, "worst_case");
    const std::size_t model = worst.rfind('|');
    const Number value = number_at(check, "value");
    Measurement m = exact(shown.key, model == std::string::npos ? "" : worst.substr(model + 1),
                          std::string(shown.what) + (worst.empty() ? "" : ", decided by " + worst), value,
                          std::string("sin² study, ") + shown.key);
    m.better = shown.deviation ? Better::Less : Better::Unknown;
    if (check.is_object()) {
      m.listed_as = value ? CaseStatus::Measured : CaseStatus::NoResult;
      make_statistic(check, m);
    }
    out.push_back(std::move(m));
  }
}

/// Checks that only gates see.
void add_other_checks(const Json& checks, Measurements& out) {
  if (!checks.is_object()) return;
  for (const auto& [name, check] : checks.items()) {
    const bool shown = std::any_of(std::begin(shown_checks), std::end(shown_checks),
                                   [&, key = name](const ShownCheck& c) { return c.key == key; });
    if (shown || name.starts_with("mutant_")) continue;  // mutants are in the report's list "must_fail"
    Measurement m{.section = "sin2_study", .subject = name, .quantity = "check", .value = number_at(check, "value")};
    make_statistic(check, m);
    out.push_back(std::move(m));
  }
}

void add_models(const Json& section, Measurements& out) {
  for (const Json& model : array_at(section, "models"))
    for (const char* key : {"cases", "undefined", "pole", "rays_dropped", "largest_error_D"}) {
      const std::string name = text_at(model, "ray_model");
      out.push_back(exact("", name, key, number_at(model, key), "sin² study, " + name + ": " + key));
    }
}

void add_population(const Json& section, Measurements& out) {
  for (const Json& row : array_at(section, "population")) {
    const auto metres = number_at(row, "distance_m");
    const std::string model = text_at(row, "ray_model");
    const std::string view = value_at(row, "accommodation").is_null()
                                 ? "worst view"
                                 : text_at(row, "accommodation") + ", " +
                                       (metres ? plain_number(*metres) + " m" : text_at(row, "distance_m"));
    const std::string name = "sin² study, real eyes, " + model + ", " + view + ": ";
    for (const char* key : {"eyes", "pole", "noticeable", "error_D/median", "error_D/p90", "error_D/max"})
      out.push_back(exact(view, model, key, number_at(row, key), name + key));
  }
}

void add_radii(const Json& view, const Json& psf, Measurements& out) {
  const std::string id = text_at(view, "id"), model = text_at(psf, "model");
  const std::string name = "sin² study, point spread " + id + ", " + model + ": ";
  for (const char* radius : {"radius_50", "radius_80"}) {
    const auto error = number_at(psf, std::string(radius) + "_error_of_independent_rays_arcmin");
    const std::string quantity = std::string(radius) + " [arcmin]";
    out.push_back({.section = "sin2_study",
                   .subject = id,
                   .model = model,
                   .quantity = quantity,
                   .value = number_at(psf, std::string(radius) + "_arcmin"),
                   .bound = error ? Number(errors_of_a_bound * *error) : std::nullopt,
                   .run_name = name + quantity});
  }
  if (model == "wavefront") return;
  // Both patterns are of random rays: by the triangle inequality their distance is off by no more than the distance
  // of two runs of the model and that of two runs of theory, half of it in each of the reports that are compared.
  out.push_back({.section = "sin2_study",
                 .subject = id,
                 .model = model,
                 .quantity = "total variation from theory",
                 .value = number_at(psf, "total_variation"),
                 .bound = number_at(view, "noise_total_variation"),
                 .run_name = name + "total variation from theory"});
}

/// Point spreads of the gallery over their own noise: a row of the table of cases, which gates judge, too.
void add_pattern(const Json& view, const Json& psf, Measurements& out) {
  const std::string id = text_at(view, "id"), model = text_at(psf, "model");
  if (model == "wavefront") return;  // theory itself
  const Number ratio = number_at(psf, "total_variation_over_noise");
  const bool astigmatic = number_at(view, "cylinder_D").value_or(1.0) != 0.0;
  out.push_back({.section = "sin2_study",
                 .subject = id,
                 .model = model,
                 .quantity = over_noise,
                 .value = ratio,
                 .listed_as = !ratio                  ? CaseStatus::NoResult
                              : *ratio > same_pattern ? CaseStatus::Differs
                                                      : CaseStatus::Agrees});
  if (model == "sin2_radial" && astigmatic)
    out.push_back({.section = "sin2_study", .subject = id, .model = model, .quantity = rose, .value = ratio});
}

}  // namespace

void measure_sin2_study(const Json& report, Measurements& out) {
  const Json& section = value_at(report, "sin2_study");
  add_shown_checks(value_at(section, "checks"), out);
  add_other_checks(value_at(section, "checks"), out);
  add_models(section, out);
  add_population(section, out);
  for (const Json& view : array_at(section, "gallery"))
    for (const Json& psf : array_at(view, "models")) {
      add_radii(view, psf, out);
      add_pattern(view, psf, out);
    }
}

std::span<const StatisticRule> sin2_study_rules() {
  static constexpr StatisticRule rules[] = {
      {"sin2_study/gallery_sin2_over_noise_min", "sin2_study", rose, "sin2_radial", Extreme::Of::Smallest},
      {"sin2_study/gallery_repaired_over_noise_max", "sin2_study", over_noise, "repaired"},
  };
  return rules;
}

}  // namespace sturm
