#include "experiments/standard/sin2_findings.h"

#include <algorithm>
#include <cmath>

#include "compare/ellipses/ellipse_comparison.h"
#include "compare/statistics/median.h"
#include "io/files/formatted_text.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// Below this cylinder [D] the two models agree so closely that a ratio of their differences is all noise.
constexpr double least_cylinder_D = 0.1;

/// A true axis shorter than this share of the longer one has no meaningful ratio: a focal line.
constexpr double least_axis_ratio = 0.01;

Eigen::Vector2d semi_axes_arcmin(const Ellipse& e) {
  return {e.semi_major * arcminutes_per_radian, e.semi_minor * arcminutes_per_radian};
}

/// Principal values of the vergence matrix I/d + F − A·I of a case.
PrincipalValues vergences_of(const TracedCase& c) {
  const PowerMatrix& f = c.eye.correction;
  const double shift = vergence_of(c.footprint.distance_m) - c.footprint.accommodation_D;
  return principal_values(f.xx() + shift, f.xy(), f.yy() + shift);
}

/// Variances along the principal meridian of the higher power, and across it.
struct AxisVariances {
  double high, low;
  AxisVariances(const Eigen::Matrix2d& covariance, const Eigen::Vector2d& u)
      : high(u.dot(covariance * u)), low(covariance.trace() - high) {}
};

Sin2Case semi_axes_of(const TracedCase& c, const PrincipalValues& vergences, const Ellipse& sin2) {
  const Eigen::Matrix2d closed_form = sin2_closed_form_covariance(c.footprint.angular, c.eye.pupil_radius_m);
  const Eigen::Vector2d axes = semi_axes_arcmin(sin2);
  const Eigen::Vector2d truth = semi_axes_arcmin(Ellipse::image_of_disc(c.footprint.angular, c.eye.pupil_radius_m));
  return {.id = c.id,
          .high_D = vergences.high,
          .low_D = vergences.low,
          .true_semi_axes_arcmin = truth,
          .sin2_semi_axes_arcmin = axes,
          .closed_form_semi_axes_arcmin = semi_axes_arcmin(Ellipse::of_second_moments(closed_form)),
          .ratio_major = axes.x() / truth.x(),
          .ratio_minor = truth.y() > least_axis_ratio * truth.x() ? Number(axes.y() / truth.y()) : std::nullopt};
}

}  // namespace

Sin2Findings sin2_findings(std::span<const TracedCase> cases) {
  Sin2Findings findings;
  std::vector<double> ratios;
  double worst_ratio = 0.0, worst_loss = 0.0;
  for (const TracedCase& traced : cases) {
    const BundleEllipse* sin2 = traced.ellipse_of(RayModel::sin2_radial);
    const PrincipalValues v = vergences_of(traced);
    const double a = traced.eye.pupil_radius_m, c = v.high - v.low;
    if (!sin2 || !(a > 0.0) || c < least_cylinder_D) continue;
    const AxisVariances truth(covariance_of_disc_image(traced.footprint.angular, a), v.high_direction);
    const AxisVariances measured(sin2->covariance, v.high_direction);
    // At a circle of least confusion the principal variances of both models are equal: nothing to compare.
    if (std::abs(truth.high - truth.low) > 1e-3 * (truth.high + truth.low)) {
      ratios.push_back((measured.high - measured.low) / (truth.high - truth.low));
      worst_ratio = std::max(worst_ratio, std::abs(ratios.back() - 0.5));
    }
    const double predicted_loss = a * a * c * c / 16.0;
    worst_loss =
        std::max(worst_loss, std::abs((truth.high + truth.low - measured.high - measured.low) / predicted_loss - 1.0));
    findings.table.push_back(semi_axes_of(traced, v, sin2->ellipse));
  }
  findings.cases_with_cylinder = findings.table.size();
  if (const auto middle = median(ratios)) {
    findings.ratio = VarianceRatio{.measured_median = *middle, .predicted = 0.5, .worst_deviation = worst_ratio};
    findings.worst_deviation_of_lost_variance = worst_loss;
  }
  return findings;
}

std::optional<std::string> sin2_sentence(const Sin2Findings& sin2) {
  if (!sin2.ratio || !sin2.ratio->measured_median || !sin2.ratio->worst_deviation) return std::nullopt;
  double least_major = 1.0, most_major = 0.0;
  for (const Sin2Case& c : sin2.table) {
    least_major = std::min(least_major, c.ratio_major.value_or(least_major));
    most_major = std::max(most_major, c.ratio_major.value_or(most_major));
  }
  return formatted(
      "In %zu cases with cylinder, sin² interpolation reproduces %.4f of the true difference of the principal "
      "variances (closed form: 0.5, worst deviation %.1e): it keeps only the radial part of the wavefront's slope, and "
      "its major axes come out at %.2f to %.2f of the true ones.",
      sin2.table.size(), *sin2.ratio->measured_median, *sin2.ratio->worst_deviation, least_major, most_major);
}

}  // namespace sturm
