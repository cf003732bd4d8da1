#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "compare/statistics/median.h"
#include "experiments/run/sections.h"
#include "io/json/values.h"
#include "lensmodel/power_matrix.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// Below this cylinder [D] the two models agree so closely that a ratio of their differences is all noise.
constexpr double least_cylinder_D = 0.1;

Json arcminutes(const Json& semi_axes_rad) {
  return {semi_axes_rad.at(0).get<double>() * arcminutes_per_radian,
          semi_axes_rad.at(1).get<double>() * arcminutes_per_radian};
}

const Json* rays_of(const Json& entry, const char* model) {
  for (const Json& rays : entry.at("rays"))
    if (rays.at("ray_model") == model && rays.at("status") == "ok") return &rays;
  return nullptr;
}

/// The vergence matrix I/d + F − A·I of a case and its principal values.
PrincipalValues vergence_of(const Json& entry) {
  const PowerMatrix f = power_at_cornea({entry.at("sphere_D"), entry.at("cylinder_D"), entry.at("axis_deg"),
                                         1e-3 * entry.at("vertex_distance_mm").get<double>()});
  const Json& d = entry.at("distance_m");
  const double shift = (d.is_string() ? 0.0 : 1.0 / d.get<double>()) - entry.at("accommodation_D").get<double>();
  return principal_values(f.xx() + shift, f.xy(), f.yy() + shift);
}

/// Variances along the principal meridian of the higher power, and across it.
struct AxisVariances {
  double high, low;
  AxisVariances(const Eigen::Matrix2d& covariance, const Eigen::Vector2d& u)
      : high(u.dot(covariance * u)), low(covariance.trace() - high) {}
};

}  // namespace

Json sin2_findings(const Json& ellipses) {
  Json table = Json::array();
  std::vector<double> ratios;
  double worst_ratio = 0.0, worst_loss = 0.0;
  for (const Json& entry : ellipses.at("cases")) {
    const Json* sin2 = rays_of(entry, "sin2_radial");
    const PrincipalValues v = vergence_of(entry);
    const double a = 0.5e-3 * entry.at("pupil_mm").get<double>(), c = v.high - v.low;
    if (!sin2 || !(a > 0.0) || c < least_cylinder_D) continue;
    const AxisVariances truth(symmetric_from(entry.at("conoid").at("covariance_rad2")), v.high_direction);
    const AxisVariances measured(symmetric_from(sin2->at("covariance_rad2")), v.high_direction);
    // At a circle of least confusion the principal variances of both models are equal: nothing to compare.
    if (std::abs(truth.high - truth.low) > 1e-3 * (truth.high + truth.low)) {
      ratios.push_back((measured.high - measured.low) / (truth.high - truth.low));
      worst_ratio = std::max(worst_ratio, std::abs(ratios.back() - 0.5));
    }
    const double predicted_loss = a * a * c * c / 16.0;
    worst_loss =
        std::max(worst_loss, std::abs((truth.high + truth.low - measured.high - measured.low) / predicted_loss - 1.0));
    const Json truth_axes = arcminutes(entry.at("conoid").at("semi_axes_rad")),
               axes = arcminutes(sin2->at("semi_axes_rad"));
    const double true_major = truth_axes.at(0), true_minor = truth_axes.at(1);
    table.push_back({{"case", entry.at("id")},
                     {"V1_D", v.high},
                     {"V2_D", v.low},
                     {"true_semi_axes_arcmin", truth_axes},
                     {"sin2_semi_axes_arcmin", axes},
                     {"closed_form_semi_axes_arcmin", arcminutes(entry.at("sin2_closed_form").at("semi_axes_rad"))},
                     {"ratio_major", axes.at(0).get<double>() / true_major},
                     {"ratio_minor",
                      true_minor > 0.01 * true_major ? Json(axes.at(1).get<double>() / true_minor) : Json(nullptr)}});
  }
  Json section = {{"cases_with_cylinder", table.size()},
                  {"table", std::move(table)},
                  {"ratio_of_difference_of_principal_variances", nullptr},
                  {"lost_total_variance", nullptr}};
  if (const auto middle = median(ratios)) {
    section["ratio_of_difference_of_principal_variances"] = {
        {"measured_median", *middle}, {"predicted", 0.5}, {"worst_deviation", worst_ratio}};
    section["lost_total_variance"] = {{"worst_deviation_relative", worst_loss}};
  }
  return section;
}

Json sin2_sentence(const Json& sin2) {
  if (sin2.is_null() || sin2.at("ratio_of_difference_of_principal_variances").is_null()) return nullptr;
  const Json& ratio = sin2.at("ratio_of_difference_of_principal_variances");
  double least_major = 1.0, most_major = 0.0;
  for (const Json& row : sin2.at("table")) {
    least_major = std::min(least_major, row.at("ratio_major").get<double>());
    most_major = std::max(most_major, row.at("ratio_major").get<double>());
  }
  char text[512];
  std::snprintf(text, sizeof text,
                "In %zu cases with cylinder, sin² interpolation reproduces %.4f of the true difference of the "
                "principal variances (closed "
                "form: 0.5, worst deviation %.1e): "
                "it keeps only the radial part of the wavefront's slope, and its major axes come out at %.2f to %.2f "
                "of the true ones.",
                sin2.at("table").size(), ratio.at("measured_median").get<double>(),
                ratio.at("worst_deviation").get<double>(), least_major, most_major);
  return text;
}

}  // namespace sturm
