#include "experiments/stress/oracle_checks.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "conoid/tracing/footprint.h"
#include "lensmodel/prism.h"
#include "lensmodel/symmetric2.h"

namespace sturm::stress {

namespace {

/// Frobenius norm of the difference, taken in extended precision.
double difference(const Eigen::Matrix2d& a, const ExtendedMatrix& b) {
  Extended sum = 0.0L;
  for (Eigen::Index i = 0; i < 2; ++i)
    for (Eigen::Index j = 0; j < 2; ++j) {
      const Extended d = static_cast<Extended>(a(i, j)) - b[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      sum += d * d;
    }
  return static_cast<double>(std::sqrt(sum));
}

ExtendedMatrix block(const std::array<std::array<Extended, 4>, 2>& m, std::size_t first) {
  return {{{m[0][first], m[0][first + 1]}, {m[1][first], m[1][first + 1]}}};
}

double norm(const ExtendedMatrix& m) {
  return static_cast<double>(std::sqrt(m[0][0] * m[0][0] + m[0][1] * m[0][1] + m[1][0] * m[1][0] + m[1][1] * m[1][1]));
}

double distance(const Eigen::Vector3d& a, const Vec3<Extended>& b) {
  const Vec3<Extended> d = extended(a) - b;
  return static_cast<double>(std::sqrt(dot(d, d)));
}

void check_curvature(Outcomes& outcomes, const SpectacleConoid& conoid, const ExtendedTrace& oracle,
                     const ErrorBounds& bounds, const Eigen::Matrix2d& slopes) {
  const double s = slopes.norm();
  const Eigen::Matrix2d a = conoid.exit.offsets(slopes);
  const double a_error =
      bounds.offset_p + bounds.offset_q * s +
      formula_error * (conoid.exit.offset_from_offset.norm() + conoid.exit.offset_from_slope.norm() * s);
  const double b_error =
      bounds.slope_p + bounds.slope_q * s +
      formula_error * (conoid.exit.slope_from_offset.norm() + conoid.exit.slope_from_slope.norm() * s);
  const double inverse = 1.0 / singular_values(a).small;  // ‖A⁻¹‖ in the spectral norm: ‖δB A⁻¹‖ ≤ ‖δB‖ of that
  // First order in the errors: where A's error is not small against A there is no bound, and a program that says none
  // is right.
  if (!(a_error * inverse < 0.01)) return outcomes.skip(Check::curvature, Skip::focal_line);
  const auto k = conoid.exit_curvature(slopes);
  const auto exact = oracle.exit_curvature(slopes);
  if (!k || !exact) return outcomes.expect(Check::curvature, !k == !exact);
  const double size = norm(*exact);
  outcomes.record(Check::curvature, difference(*k, *exact),
                  1.1 * (b_error + size * a_error) * inverse + formula_error * a.norm() * inverse * size, size);
}

}  // namespace

void check_against_oracle(Outcomes& outcomes, const SpectacleConoid& conoid, const ExtendedTrace& oracle,
                          const ErrorBounds& bounds, const Eigen::Matrix2d& slopes, double vergence_D) {
  outcomes.record(Check::exit_point, distance(conoid.chief_ray.origin, oracle.exit_point), bounds.exit_point, 1.0);
  outcomes.record(Check::exit_direction, distance(conoid.chief_ray.direction, oracle.direction), bounds.direction, 1.0);
  const RayTransfer& t = conoid.exit;
  const auto compare = [&](const Eigen::Matrix2d& m, const ExtendedMatrix& exact, double bound, double smallest) {
    outcomes.record(Check::footprint, difference(m, exact), bound, std::max(smallest, norm(exact)));
  };
  compare(t.offset_from_offset, block(oracle.offset, 0), bounds.offset_p, 1.0);
  compare(t.offset_from_slope, block(oracle.offset, 2), bounds.offset_q, 0.0);
  compare(t.slope_from_slope, block(oracle.slope, 2), bounds.slope_q, 1.0);
  // A lens without power has no size to compare this block with: the footprint's is taken.
  const double s = slopes.norm(), size = (vergence_D * t.offset_from_offset).norm() + t.slope_from_offset.norm() +
                                         (vergence_D * t.offset_from_slope.norm() + t.slope_from_slope.norm()) * s;
  outcomes.record(Check::footprint, difference(t.slope_from_offset, block(oracle.slope, 0)), bounds.slope_p,
                  std::max(1.0, size));
  outcomes.record(
      Check::footprint,
      difference(conoid.angular_footprint(slopes, vergence_D), oracle.angular_footprint(slopes, vergence_D)),
      bounds.angular_footprint(s, vergence_D) + formula_error * size, std::max(1.0, size));
  check_curvature(outcomes, conoid, oracle, bounds, slopes);
}

namespace {

/// Distance of a crossing from the border of a surface that has one within its reach [m].
double from_border(const Surface& surface, const Crossing& at) {
  const auto* spline = std::get_if<BSplineSurface>(&surface);
  if (!spline) return HUGE_VAL;
  const Eigen::Vector2d p(at.x, at.y);
  return std::min((p - spline->grid().first).cwiseAbs().minCoeff(), (spline->grid().last() - p).cwiseAbs().minCoeff());
}

}  // namespace

void check_status(Outcomes& outcomes, LensStatus status, const Spectacles& lens, const ExtendedTrace& oracle,
                  const ErrorBounds& bounds) {
  if (status == oracle.status) return outcomes.expect(Check::status, status != LensStatus::no_convergence);
  // A search that did not end is no defect where there is nothing to find: the ray is lost either way.
  if (status == LensStatus::no_convergence && oracle.status != LensStatus::ok)
    return outcomes.expect(Check::status, true);
  // They differ. Rounding may decide at the rim, at the critical angle and where a ray grazes; the program's search may
  // also miss two crossings that are closer than 1/16 of the way through the rim's cylinder (lensmodel/surface.h).
  const double rim = 0.5 * lens.diameter_m;
  for (int i = 0; i < oracle.crossings; ++i) {
    const Crossing& at = oracle.at[static_cast<std::size_t>(i)];
    const auto k = static_cast<std::size_t>(i);
    const double from_axis = std::hypot(at.x, at.y);
    const double bend =
        at.on_sheet ? at.shape.hessian / std::sqrt(1.0 + at.shape.gradient * at.shape.gradient) : HUGE_VAL;
    const bool at_rim = std::abs(from_axis - rim) <= bounds.hit[k] + 1e-11 * rim,
               critical = std::abs(at.radicand) <= bounds.radicand[k];
    const bool at_border = from_border(i == 0 ? lens.back : lens.front, at) <= bounds.hit[k];
    const bool grazes = at.cos_in <= bounds.cos_in[k], close_pair = 2.0 * at.cos_in <= bend * 4.0 * rim / 16.0;
    if (at_rim || at_border || critical || grazes || (close_pair && status == LensStatus::missed_lens))
      return outcomes.skip(Check::status, Skip::at_the_edge);
  }
  outcomes.expect(Check::status, false);
}

namespace {

constexpr Extended radians = std::numbers::pi_v<Extended> / 180.0L;

}  // namespace

void check_prism(Outcomes& outcomes, const Spectacles& lens, double prism_cm_per_m, double base_deg) {
  Spectacles straight = lens;
  straight.mounting = Mounting().with_wedge(lens.mounting.wedge());
  const StartingPoints axis{straight.back_vertex(),
                            straight.back_vertex() - Eigen::Vector3d(0.0, 0.0, lens.center_thickness_m)};
  const ExtendedTrace t = trace_extended(straight, {0.0, 0.0, -1.0}, 0.0, axis);
  if (t.status != LensStatus::ok) return outcomes.expect(Check::prism, false);
  // Towards the base: 0 is the wearer's left, 90 up.
  const Extended wanted = 0.01L * prism_cm_per_m, base = radians * base_deg;
  const Extended x = t.direction.x / -t.direction.z + wanted * std::cos(base),
                 y = t.direction.y / -t.direction.z - wanted * std::sin(base);
  const double size = static_cast<double>(wanted);
  const double bound =
      prism_accuracy + (1.0 + size * size) * error_bounds(straight, 0.0, t).direction + formula_error * size;
  outcomes.record(Check::prism, static_cast<double>(std::hypot(x, y)), bound, std::max(1e-300, size));
}

namespace {

struct ExactCorrection {
  Extended xx, xy, yy, determinant, size_F;
};

/// F_c = F (I − dF)⁻¹ with F from the power vector (wearer frame: J45 changes its sign).
ExactCorrection exact_correction(const Prescription& rx) {
  const Extended c = rx.cylinder_D, m = rx.sphere_D + 0.5L * c, d = rx.vertex_distance_m,
                 twice = 2.0L * radians * rx.axis_deg;
  const Extended j0 = -0.5L * c * std::cos(twice), xy = 0.5L * c * std::sin(twice), xx = m + j0, yy = m - j0;
  const Extended a = 1.0L - d * xx, b = -d * xy, e = 1.0L - d * yy, det = a * e - b * b;
  // F times the adjugate [[e, −b], [−b, a]] of I − dF.
  return {(xx * e - xy * b) / det, (xy * a - xx * b) / det, (yy * a - xy * b) / det, det,
          std::sqrt(xx * xx + 2.0L * xy * xy + yy * yy)};
}

}  // namespace

double correction_bound(const Prescription& rx) {
  const ExactCorrection exact = exact_correction(rx);
  const double f = std::abs(rx.sphere_D) + std::abs(rx.cylinder_D), d = rx.vertex_distance_m, grown = 1.0 + d * f;
  const double det = static_cast<double>(std::abs(exact.determinant));
  // Entries of F are rounded to formula_error·f; so are numerator and determinant, each a sum of terms of the size (1 +
  // d f)².
  return formula_error * f * grown / det * (1.0 + grown * grown / det);
}

void check_correction(Outcomes& outcomes, const Prescription& rx, const Eye* eye) {
  const ExactCorrection exact = exact_correction(rx);
  constexpr double refused_below = 1e-9;  // |det(I − dF)|, docs/theory.md#2-from-a-prescription-to-a-power-matrix
  const double f = std::abs(rx.sphere_D) + std::abs(rx.cylinder_D), grown = 1.0 + rx.vertex_distance_m * f;
  const double det = static_cast<double>(std::abs(exact.determinant)), rounding = formula_error * grown * grown;
  if (!eye) return outcomes.expect(Check::correction, det <= refused_below + rounding);
  if (!(det > refused_below - rounding)) return outcomes.expect(Check::correction, false);
  const PowerMatrix& got = eye->correction;
  const ExtendedMatrix expected{{{exact.xx, exact.xy}, {exact.xy, exact.yy}}};
  // Beyond first order the determinant's error must be small against itself.
  if (rounding / det > 0.01) return outcomes.skip(Check::correction, Skip::focal_line);
  outcomes.record(Check::correction, difference(got.matrix(), expected), 1.1 * correction_bound(rx), norm(expected));
}

}  // namespace sturm::stress
