#include "compare/findings/ellipses.h"

#include <algorithm>
#include <cmath>

#include "compare/findings/measured.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

constexpr double least_cylinder_D = 0.5;  // below it the two ray models are too close for their difference to be a test
constexpr int components = 3;             // of a covariance: z_max is the largest of so many

constexpr const char* z_conoid = "largest |z| of the covariance, from the conoid";
constexpr const char* relative_conoid = "relative difference of covariances, from the conoid";
constexpr const char* z_form = "largest |z| of the covariance, from the closed form";
constexpr const char* relative_form = "relative difference of covariances, from the closed form";
constexpr const char* z_round = "largest |z| of the covariance, from the conoid, without a cylinder";
constexpr const char* relative_round = "relative difference of covariances, from the conoid, without a cylinder";
constexpr const char* z_astigmatic = "largest |z| of the covariance, from the conoid, with a cylinder";
constexpr const char* ratio_astigmatic = "relative difference of covariances, measured over that of the closed form";

/// The rays of one model in a case, or null.
const Json& rays_of(const Json& ellipse_case, const std::string& model) {
  static const Json none;
  for (const Json& rays : array_at(ellipse_case, "rays"))
    if (text_at(rays, "ray_model") == model) return rays;
  return none;
}

/// Frobenius distance of two covariances [xx, xy, yy] relative to the second.
Number relative_difference(const Json& of, const Json& from) {
  double difference = 0.0, norm = 0.0;
  for (const auto& [index, weight] : {std::pair{"0", 1.0}, {"1", 2.0}, {"2", 1.0}}) {
    const Number a = number_at(of, index), b = number_at(from, index);
    if (!a || !b) return std::nullopt;
    difference += weight * (*a - *b) * (*a - *b);
    norm += weight * *b * *b;
  }
  return norm > 0.0 ? Number(std::sqrt(difference / norm)) : std::nullopt;
}

void add(const std::string& id, const char* model, const char* quantity, const Number& value, Measurements& out) {
  out.push_back({.section = "ellipses", .subject = id, .model = model, .quantity = quantity, .value = value});
}

/// What gates judge: also of rays that a case lacks, as missing evidence is not evidence.
void add_judged(const Json& c, Measurements& out) {
  const std::string id = text_at(c, "id");
  const Number cylinder = number_at(c, "cylinder_D");
  const Json &matrix = rays_of(c, "power_matrix"), &sin2 = rays_of(c, "sin2_radial"), &lens = rays_of(c, "thin_lens");
  add(id, "power_matrix", z_conoid, number_at(matrix, "against_conoid/z_max"), out);
  add(id, "sin2_radial", z_form, number_at(sin2, "against_closed_form/z_max"), out);
  if (!cylinder || *cylinder == 0.0) {
    add(id, "thin_lens", z_round, number_at(lens, "against_conoid/z_max"), out);
    add(id, "thin_lens", relative_round, number_at(lens, "against_conoid/relative_frobenius"), out);
  }
  if (!cylinder || std::abs(*cylinder) >= least_cylinder_D) {
    const Number predicted =
        relative_difference(value_at(c, "sin2_closed_form/covariance_rad2"), value_at(c, "conoid/covariance_rad2"));
    add(id, "sin2_radial", z_astigmatic, number_at(sin2, "against_conoid/z_max"), out);
    add(id, "sin2_radial", ratio_astigmatic, quotient(number_at(sin2, "against_conoid/relative_frobenius"), predicted),
        out);
  }
}

/// What another run of the same experiment has, too.
void add_compared(const Json& c, const Number& degrees, Measurements& out) {
  const std::string id = text_at(c, "id"), name = "ellipse " + id;
  for (const auto& [index, axis] : {std::pair("0", "major"), std::pair("1", "minor")})
    out.push_back({.section = "ellipses",
                   .subject = id,
                   .model = "conoid",
                   .quantity = std::string("semi-") + axis + " axis [rad]",
                   .value = number_at(c, std::string("conoid/semi_axes_rad/") + index),
                   .run_name = name + ", conoid: semi-" + axis + " axis [rad]"});
  for (const Json& rays : array_at(c, "rays")) {
    const std::string model = text_at(rays, "ray_model");
    const Json& prediction = value_at(c, model == "sin2_radial" ? "sin2_closed_form" : "conoid");
    for (const auto& [index, component] : {std::pair("0", "xx"), std::pair("1", "xy"), std::pair("2", "yy")}) {
      const std::string at = index, quantity = std::string("covariance ") + component + " [rad²]";
      out.push_back({.section = "ellipses",
                     .subject = id,
                     .model = model,
                     .quantity = quantity,
                     .value = number_at(rays, "covariance_rad2/" + at),
                     .standard_error = number_at(rays, "covariance_standard_error_rad2/" + at),
                     .degrees = degrees,
                     .better = Better::Nearer,
                     .target = number_at(prediction, "covariance_rad2/" + at),
                     .run_name = name + ", " + model + ": " + quantity});
    }
  }
}

/// Rows of the table of cases, which gates judge, too: what they look for and a case lacks is listed without a value.
void add_rows(const Json& c, Measurements& out) {
  const std::string id = text_at(c, "id");
  const std::size_t first = out.size();
  for (const Json& rays : array_at(c, "rays")) {
    const bool closed =
        text_at(rays, "ray_model") == "sin2_radial" && value_at(rays, "against_closed_form").is_object();
    const Json& own = value_at(rays, closed ? "against_closed_form" : "against_conoid");
    add(id, text_at(rays, "ray_model").c_str(), closed ? relative_form : relative_conoid,
        number_at(own, "relative_frobenius"), out);
    out.back().z = number_at(own, "z_max");
    out.back().listed_as = text_at(rays, "status") == "ok" ? CaseStatus::Measured : CaseStatus::NoResult;
  }
  for (const auto& [model, quantity] : {std::pair("power_matrix", relative_conoid), {"sin2_radial", relative_form}})
    if (std::none_of(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
                     [&](const Measurement& m) { return m.model == model && m.quantity == quantity; }))
      add(id, model, quantity, std::nullopt, out);
}

}  // namespace

void measure_ellipses(const Json& report, Measurements& out) {
  const Number degrees = degrees_of(number_at(report, "ellipses/conditions/replicates"));
  const Json& cases = array_at(report, "ellipses/cases");
  const std::size_t first = out.size();
  for (const Json& c : cases) add_rows(c, out);
  mark_by_z(std::span(out).subspan(first), components);
  for (const Json& c : cases) {
    add_judged(c, out);
    add_compared(c, degrees, out);
  }
}

std::span<const StatisticRule> ellipse_rules() {
  using Of = Extreme::Of;
  static constexpr StatisticRule rules[] = {
      {"matrix_vs_conoid_max_z", "ellipses", z_conoid, "power_matrix"},
      {"matrix_vs_conoid_max_relative", "ellipses", relative_conoid, "power_matrix"},
      {"thin_lens_vs_conoid_max_z", "ellipses", z_round, "thin_lens"},
      {"thin_lens_vs_conoid_max_relative", "ellipses", relative_round, "thin_lens"},
      {"sin2_vs_closed_form_max_z", "ellipses", z_form, "sin2_radial"},
      {"sin2_vs_closed_form_max_relative", "ellipses", relative_form, "sin2_radial"},
      {"sin2_vs_conoid_min_z", "ellipses", z_astigmatic, "sin2_radial", Of::Smallest},
      {"sin2_vs_conoid_min_relative_difference_ratio", "ellipses", ratio_astigmatic, "sin2_radial", Of::Smallest},
      {"sin2_vs_conoid_max_relative_difference_ratio", "ellipses", ratio_astigmatic, "sin2_radial"},
  };
  return rules;
}

}  // namespace sturm
