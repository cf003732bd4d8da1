#include "compare/findings/ellipse_numbers.h"

#include <algorithm>
#include <cmath>

#include "compare/findings/ellipses.h"
#include "compare/findings/measured.h"
#include "io/json/stored_values.h"

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

void add(const std::string& id, const std::optional<RayModel>& model, const char* quantity, const Number& value,
         Measurements& out) {
  out.push_back({.section = "ellipses", .subject = id, .model = name_of(model), .quantity = quantity, .value = value});
}

EllipseAgreement with_conoid(const RayFinding* rays) {
  return rays && rays->against_conoid ? rays->against_conoid->agreement : EllipseAgreement{};
}

EllipseAgreement with_closed_form(const RayFinding* rays) {
  return rays ? rays->against_closed_form.value_or(EllipseAgreement{}) : EllipseAgreement{};
}

/// What gates judge: also of rays that a case lacks, as missing evidence is not evidence.
void add_judged(const EllipseFinding& c, Measurements& out) {
  const RayFinding* sin2 = c.rays_of(RayModel::sin2_radial);
  const EllipseAgreement lens = with_conoid(c.rays_of(RayModel::thin_lens));
  add(c.id, RayModel::power_matrix, z_conoid, with_conoid(c.rays_of(RayModel::power_matrix)).z_max, out);
  add(c.id, RayModel::sin2_radial, z_form, with_closed_form(sin2).z_max, out);
  if (!c.cylinder_D || *c.cylinder_D == 0.0) {
    add(c.id, RayModel::thin_lens, z_round, lens.z_max, out);
    add(c.id, RayModel::thin_lens, relative_round, lens.relative_frobenius, out);
  }
  if (!c.cylinder_D || std::abs(*c.cylinder_D) >= least_cylinder_D) {
    const EllipseAgreement astigmatic = with_conoid(sin2);
    add(c.id, RayModel::sin2_radial, z_astigmatic, astigmatic.z_max, out);
    add(c.id, RayModel::sin2_radial, ratio_astigmatic,
        quotient(astigmatic.relative_frobenius, c.predicted_difference()), out);
  }
}

/// Semi-axes of the conoid, which have no noise.
void add_conoid(const EllipseFinding& c, Measurements& out) {
  const std::optional<Ellipse>& e = c.conoid.ellipse;
  const Number major = e ? Number(e->semi_major) : std::nullopt, minor = e ? Number(e->semi_minor) : std::nullopt;
  for (const auto& [value, axis] : {std::pair(major, "major"), std::pair(minor, "minor")}) {
    const std::string quantity = std::string("semi-") + axis + " axis [rad]";
    out.push_back({.section = "ellipses",
                   .subject = c.id,
                   .model = "conoid",
                   .quantity = quantity,
                   .value = value,
                   .run_name = "ellipse " + c.id + ", conoid: " + quantity});
  }
}

/// Entries of the covariance of one model's rays.
void add_covariance(const EllipseFinding& c, const RayFinding& rays, const Number& degrees, Measurements& out) {
  const std::optional<Eigen::Matrix2d>& predicted =
      rays.model == RayModel::sin2_radial ? c.sin2_closed_form.covariance_rad2 : c.conoid.covariance_rad2;
  const auto entry = [](const std::optional<Eigen::Matrix2d>& m, int i, int j) {
    return m ? Number((*m)(i, j)) : std::nullopt;
  };
  struct Component {
    int i, j;
    const char* name;
  };
  for (const auto& [i, j, component] : {Component{0, 0, "xx"}, Component{0, 1, "xy"}, Component{1, 1, "yy"}}) {
    const std::string model = name_of(rays.model), quantity = std::string("covariance ") + component + " [rad²]";
    const auto& errors = rays.covariance_standard_error_rad2;
    out.push_back({.section = "ellipses",
                   .subject = c.id,
                   .model = model,
                   .quantity = quantity,
                   .value = entry(rays.covariance_rad2, i, j),
                   .standard_error = errors ? Number((*errors)(i + j)) : std::nullopt,
                   .degrees = degrees,
                   .better = Better::Nearer,
                   .target = entry(predicted, i, j),
                   .run_name = "ellipse " + c.id + ", " + model + ": " + quantity});
  }
}

/// Rows of the table of cases, which gates judge, too: what they look for and a case lacks is listed without a value.
void add_rows(const EllipseFinding& c, Measurements& out) {
  const std::size_t first = out.size();
  for (const RayFinding& rays : c.rays) {
    const bool closed = rays.model == RayModel::sin2_radial && rays.against_closed_form;
    const EllipseAgreement own = closed ? with_closed_form(&rays) : with_conoid(&rays);
    add(c.id, rays.model, closed ? relative_form : relative_conoid, own.relative_frobenius, out);
    out.back().z = own.z_max;
    out.back().listed_as = rays.status == RayStatus::Ok ? CaseStatus::Measured : CaseStatus::NoResult;
  }
  for (const auto& [model, quantity] :
       {std::pair(RayModel::power_matrix, relative_conoid), {RayModel::sin2_radial, relative_form}})
    if (std::none_of(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
                     [&, model = name_of(model), quantity = quantity](const Measurement& m) {
                       return m.model == model && m.quantity == quantity;
                     }))
      add(c.id, model, quantity, std::nullopt, out);
}

}  // namespace

void measure_ellipses(const Json& report, Measurements& out) {
  const EllipseFindings findings = read_ellipses(report);
  const Number degrees = degrees_of(findings.conditions.replicates);
  const std::size_t first = out.size();
  for (const EllipseFinding& c : findings.cases) add_rows(c, out);
  mark_by_z(std::span(out).subspan(first), components);
  for (const EllipseFinding& c : findings.cases) {
    add_judged(c, out);
    add_conoid(c, out);
    for (const RayFinding& rays : c.rays) add_covariance(c, rays, degrees, out);
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
