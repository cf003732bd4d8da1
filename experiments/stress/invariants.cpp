#include "experiments/stress/invariants.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "conoid/tracing/five_variables.h"
#include "experiments/stress/oracle_checks.h"
#include "experiments/stress/transformed_lens.h"
#include "lensmodel/gaze.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm::stress {

namespace {

/// Errors of the case and of its copy, whose inputs are rounded once more (8 u on top of the model's 16 u): 1 + 24/16,
/// and some for the transformation itself.
constexpr double of_both = 4.0;

/// True where rounding decides what becomes of the ray, so that a copy may be lost.
bool at_the_edge(const Traced& t) {
  const double rim = 0.5 * t.lens.diameter_m;
  for (std::size_t k = 0; k < 2; ++k) {
    const Crossing& at = t.oracle.at[k];
    if (std::abs(std::hypot(at.x, at.y) - rim) <= of_both * t.bounds.hit[k] + 1e-11 * rim) return true;
    if (at.radicand <= of_both * t.bounds.radicand[k] || at.cos_in <= of_both * t.bounds.cos_in[k]) return true;
  }
  return false;
}

/// Compares the conoid with a copy that was turned back.
void compare(Outcomes& outcomes, Check check, const Traced& t, const SpectacleConoid& copy, const RayTransfer& back,
             const Eigen::Vector3d& exit) {
  if (copy.status != LensStatus::ok) {
    if (at_the_edge(t)) return outcomes.skip(check, Skip::at_the_edge);
    return outcomes.expect(check, false);
  }
  const RayTransfer& here = t.conoid.exit;
  const auto record = [&](const Eigen::Matrix2d& a, const Eigen::Matrix2d& b, double bound) {
    outcomes.record(check, (a - b).norm(), of_both * bound, 1.0);
  };
  record(here.offset_from_offset, back.offset_from_offset, t.bounds.offset_p);
  record(here.offset_from_slope, back.offset_from_slope, t.bounds.offset_q);
  record(here.slope_from_offset, back.slope_from_offset, t.bounds.slope_p);
  record(here.slope_from_slope, back.slope_from_slope, t.bounds.slope_q);
  outcomes.record(check, (t.conoid.chief_ray.origin - exit).norm(), of_both * t.bounds.exit_point, 1.0);
}

RayTransfer conjugated(const RayTransfer& r, const Eigen::Matrix2d& by) {
  RayTransfer c = r;
  for (Eigen::Matrix2d* m : {&c.offset_from_offset, &c.offset_from_slope, &c.slope_from_offset, &c.slope_from_slope})
    *m = by.transpose() * *m * by;
  return c;
}

}  // namespace

void check_symplectic(Outcomes& outcomes, const Traced& t) {
  const RayTransfer& r = t.conoid.exit;
  const Eigen::Matrix2d &a = r.offset_from_offset, &b = r.offset_from_slope, &c = r.slope_from_offset,
                        &d = r.slope_from_slope;
  const ErrorBounds& e = t.bounds;
  const double na = a.norm(), nb = b.norm(), nc = c.norm(), nd = d.norm();
  const auto record = [&](const Eigen::Matrix2d& m, double bound, double size) {
    outcomes.record(Check::symplectic, m.norm(), bound + formula_error * size, size);
  };
  record(a.transpose() * d - c.transpose() * b - Eigen::Matrix2d::Identity(),
         na * e.slope_q + nd * e.offset_p + nc * e.offset_q + nb * e.slope_p, 1.0 + na * nd + nb * nc);
  record(a.transpose() * c - c.transpose() * a, 2.0 * (na * e.slope_p + nc * e.offset_p),
         std::max(1e-300, 2.0 * na * nc));
  record(b.transpose() * d - d.transpose() * b, 2.0 * (nb * e.slope_q + nd * e.offset_q), 2.0 * nb * nd);
  const Eigen::Matrix2d offsets = r.offsets(t.slopes), slopes = r.slopes(t.slopes);
  const double s = t.slopes.norm(), no = na + nb * s, ns = nc + nd * s;
  record(offsets.transpose() * slopes - slopes.transpose() * offsets,
         2.0 * (no * (e.slope_p + e.slope_q * s) + ns * (e.offset_p + e.offset_q * s)),
         std::max(1e-300, 2.0 * no * ns));
}

void check_split(Outcomes& outcomes, const Traced& t, double fraction) {
  const Eigen::Vector3d ahead(0.0, 0.0, -1.0), pupil = turned_pupil_center(t.gaze, t.eye.rotation_center_m);
  const LensPath path = trace(t.lens, {pupil, t.gaze});
  const Eigen::Matrix3d turn = smallest_rotation(ahead, t.gaze);
  const auto moved = [&](const RayTransfer& r, double distance) {
    return transferred(transferred(r, fraction * distance), (1.0 - fraction) * distance);
  };
  RayTransfer rays = moved(RayTransfer::start(t.gaze, turn.col(0), turn.col(1)), (path.back_point - pupil).norm());
  const auto back = Interface::refracting(t.gaze, path.back.normal, 1.0, t.lens.refractive_index);
  if (!back) return outcomes.expect(Check::split, false);
  rays = moved(through(rays, *back, path.back), (path.exit.origin - path.back_point).norm());
  const auto front = Interface::refracting(rays.direction, path.front.normal, t.lens.refractive_index, 1.0);
  if (!front) return outcomes.expect(Check::split, false);
  const Eigen::Matrix3d out = smallest_rotation(ahead, path.exit.direction);
  const RayTransfer pieces = on_frame(through(rays, *front, path.front), out.col(0), out.col(1));
  const BlockBounds bounds = split_bounds(t.oracle);
  const auto record = [&](const Eigen::Matrix2d& a, const Eigen::Matrix2d& b, double bound) {
    outcomes.record(Check::split, (a - b).norm(), 2.0 * bound, std::max(1e-300, a.norm()));  // both chains are rounded
  };
  record(t.conoid.exit.offset_from_offset, pieces.offset_from_offset, bounds.offset_p);
  record(t.conoid.exit.offset_from_slope, pieces.offset_from_slope, bounds.offset_q);
  record(t.conoid.exit.slope_from_offset, pieces.slope_from_offset, bounds.slope_p);
  record(t.conoid.exit.slope_from_slope, pieces.slope_from_slope, bounds.slope_q);
}

void check_turned(Outcomes& outcomes, const Traced& t, const ConoidTracer& tracer, double angle_deg) {
  const double by_deg = possible_turn_deg(t.lens, angle_deg);
  const auto [sine, cosine] = sine_cosine_of_degrees(by_deg);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << cosine, -sine, sine, cosine;
  const SpectacleConoid copy = tracer(turned(t.lens, by_deg), turn * t.gaze, t.eye.rotation_center_m);
  compare(outcomes, Check::turned, t, copy, conjugated(copy.exit, turn.topLeftCorner<2, 2>()),
          turn.transpose() * copy.chief_ray.origin);
}

void check_scaled(Outcomes& outcomes, const Traced& t, const ConoidTracer& tracer, double k) {
  const SpectacleConoid copy = tracer(scaled(t.lens, k), t.gaze, k * t.eye.rotation_center_m);
  RayTransfer back = copy.exit;
  back.offset_from_slope /= k;
  back.slope_from_offset *= k;
  compare(outcomes, Check::scaled, t, copy, back, copy.chief_ray.origin / k);
}

void check_mirrored(Outcomes& outcomes, const Traced& t, const ConoidTracer& tracer) {
  const Eigen::Vector3d flip(-1.0, 1.0, 1.0);
  const SpectacleConoid copy = tracer(mirrored(t.lens), flip.cwiseProduct(t.gaze), t.eye.rotation_center_m);
  compare(outcomes, Check::mirrored, t, copy, conjugated(copy.exit, Eigen::Vector2d(-1.0, 1.0).asDiagonal()),
          flip.cwiseProduct(copy.chief_ray.origin));
}

void check_transposed(Outcomes& outcomes, const Prescription& rx, const SingleVisionDesign* design) {
  const double size = std::abs(rx.sphere_D) + 2.0 * std::abs(rx.cylinder_D);
  const Prescription other = transposed(rx);
  outcomes.record(Check::transposed, (PowerMatrix::from(rx).matrix() - PowerMatrix::from(other).matrix()).norm(),
                  formula_error * size, std::max(1.0, size));
  if (!design || !(design->refractive_index > 1.0)) return;
  const Spectacles a = single_vision(rx, *design), b = single_vision(other, *design);
  const auto here = sag(a.back, 0.0, 0.0), there = sag(b.back, 0.0, 0.0);
  const double powers =
      (size + std::abs(design->base_curve_D.value_or(usual_base_curve_D(rx))) * 2.0) / (design->refractive_index - 1.0);
  outcomes.record(Check::transposed, (here->hessian - there->hessian).norm(), formula_error * powers,
                  std::max(1.0, powers));
}

namespace {

double largest(const FiveVariables& w) {
  return std::max(std::abs(w.kappa1), std::abs(w.kappa2));
}

}  // namespace

void check_five_variables(Outcomes& outcomes, const Traced& t) {
  const Eigen::Matrix2d a = t.conoid.exit.offsets(t.slopes);
  const double s = t.slopes.norm(), inverse = 1.0 / singular_values(a).small;
  const auto matrix_form = t.conoid.exit_curvature(t.slopes);
  const double a_error = t.bounds.offset_p + t.bounds.offset_q * s, b_error = t.bounds.slope_p + t.bounds.slope_q * s;
  if (!matrix_form || !(a_error * inverse < 0.01)) return outcomes.skip(Check::five_variables, Skip::focal_line);
  // An error δK at a place where the bundle has A_j arrives as n_j A⁻ᵀA_jᵀ δK A_jA⁻¹; each step adds some formula_error
  // |K_j|.
  double bound = 1.1 * (b_error + matrix_form->norm() * a_error) * inverse +
                 formula_error * a.norm() * inverse * matrix_form->norm();
  const auto arriving = [&](double index, double offset_p, double offset_q, double error) {
    const double grown = (offset_p + offset_q * s) * inverse;
    bound += index * grown * grown * error;
  };
  const Eigen::Vector3d pupil = turned_pupil_center(t.gaze, t.eye.rotation_center_m);
  const LensPath path = trace(t.lens, {pupil, t.gaze});
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, t.gaze);
  const PrincipalCurvatures start = principal_curvatures(-t.slopes, turn.col(0), turn.col(1));
  FiveVariables wave{t.gaze, start.kappa1, start.kappa2, start.e1, start.e2};
  arriving(1.0, std::sqrt(2.0), 0.0, formula_error * largest(wave));
  const double n = t.lens.refractive_index;
  double hit_before = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Crossing& at = t.oracle.at[i];
    const SurfaceElement& surface = i == 0 ? path.back : path.front;
    const double length = i == 0 ? (path.back_point - pupil).norm() : (path.exit.origin - path.back_point).norm();
    const double before = i == 0 ? 1.0 : n, behind = i == 0 ? n : 1.0;
    wave = transferred(wave, length);
    if (!std::isfinite(largest(wave))) return outcomes.skip(Check::five_variables, Skip::focal_line);
    const double k_in = largest(wave);
    arriving(before, at.offset_p_in, at.offset_q_in,
             formula_error * k_in + (t.bounds.hit[i] + hit_before + formula_error * length) * k_in * k_in);
    const Eigen::Vector3d normal = surface.normal, t1 = normal.unitOrthogonal(), t2 = normal.cross(t1);
    const Eigen::Matrix2d bend = tangent_curvature(surface, t1, t2);
    const auto refracted_wave = refracted(wave, normal, principal_curvatures(bend, t1, t2), before, behind);
    if (!refracted_wave) return outcomes.skip(Check::five_variables, Skip::at_the_edge);
    wave = *refracted_wave;
    const double amplified =
        (formula_error + t.bounds.cos_in[i] / at.cos_in + 0.5 * t.bounds.radicand[i] / (at.cos_out * at.cos_out)) /
        (at.cos_out * at.cos_out);
    const double gamma = std::abs(at.cos_out - at.mu * at.cos_in), gamma_terms = at.cos_out + at.mu * at.cos_in;
    arriving(behind, at.offset_p_out, at.offset_q_out,
             amplified * (at.mu * k_in + (gamma + gamma_terms) * bend.norm()) + formula_error * largest(wave));
    hit_before = t.bounds.hit[i];
  }
  const Eigen::Vector3d &f1 = t.conoid.exit.e1, &f2 = t.conoid.exit.e2;
  const Eigen::Vector2d p(wave.e1.dot(f1), wave.e1.dot(f2)), q(wave.e2.dot(f1), wave.e2.dot(f2));
  const Eigen::Matrix2d scalar_form = wave.kappa1 * p * p.transpose() + wave.kappa2 * q * q.transpose();
  outcomes.record(Check::five_variables, (scalar_form - *matrix_form).norm(), bound,
                  std::max(1.0, matrix_form->norm()));
}

void check_accommodation(Outcomes& outcomes, const Traced& t) {
  const double amplitude = std::max(1.0, t.numbers.accommodation_D), v = t.vergence_D;
  const Eigen::Matrix2d relaxed = t.eye.correction.matrix(), x0 = t.conoid.angular_footprint(relaxed, v),
                        q = t.conoid.angular_q(v);
  const double size = t.conoid.angular_p(v).norm() + q.norm() * (relaxed.norm() + 2.0 * amplitude);
  const double rounding =
      formula_error * (size + v * (t.conoid.exit.offset_from_offset.norm() +
                                   t.conoid.exit.offset_from_slope.norm() * (relaxed.norm() + 2.0 * amplitude)));
  const auto x = [&](double a) { return t.conoid.angular_footprint(t.eye.slope_matrix(a).matrix(), v); };
  outcomes.record(Check::accommodation, (x(amplitude) - (x0 - amplitude * q)).norm(), rounding, size);
  if (t.numbers.mode != CaseNumbers::Mode::best) return;
  const double best = accommodation_through(t.conoid, t.eye, v);
  outcomes.expect(Check::accommodation, best >= 0.0 && best <= t.numbers.accommodation_D);
  const double least = singular_values(x(best)).large;
  for (const double other : {0.0, 0.5 * t.numbers.accommodation_D, t.numbers.accommodation_D, 0.99 * best,
                             std::min(1.01 * best, t.numbers.accommodation_D)})
    outcomes.record(Check::accommodation, std::max(0.0, least - singular_values(x(other)).large), rounding, size);
}

void check_infinity(Outcomes& outcomes, const Traced& t) {
  const RayTransfer& r = t.conoid.exit;
  const double s = t.slopes.norm(), a = r.offset_from_offset.norm() + r.offset_from_slope.norm() * s,
               b = r.slope_from_offset.norm() + r.slope_from_slope.norm() * s;
  const double infinite = std::numeric_limits<double>::infinity();
  const auto footprint = [&](double distance_m) {
    return spectacle_footprint(t.conoid, t.eye, distance_m, 0.0).angular;
  };
  const Eigen::Matrix2d limit = footprint(infinite);
  const double s0 = t.eye.correction.matrix().norm(), a0 = a + r.offset_from_slope.norm() * (s0 + s),
               b0 = b + r.slope_from_slope.norm() * (s0 + s);
  const Eigen::Matrix2d offsets = r.offsets(t.eye.correction.matrix());
  for (const double distance_m : {1e3, 1e6, 1e12})
    outcomes.record(Check::infinity, (footprint(distance_m) - limit - offsets / distance_m).norm(),
                    formula_error * (b0 + a0 / distance_m), std::max(1e-300, b0));
  if (t.numbers.mode != CaseNumbers::Mode::best) return;
  // The least major axis over A changes with 1/d no faster than the footprints do.
  const double amplitude = t.numbers.accommodation_D, all_a = a0 + r.offset_from_slope.norm() * amplitude,
               all_b = b0 + r.slope_from_slope.norm() * amplitude;
  const auto least = [&](double v) {
    return singular_values(
               t.conoid.angular_footprint(t.eye.slope_matrix(accommodation_through(t.conoid, t.eye, v)).matrix(), v))
        .large;
  };
  outcomes.record(Check::infinity, std::abs(least(1e-9) - least(0.0)), 2.0 * 1e-9 * all_a + formula_error * all_b,
                  std::max(1e-300, all_b));
}

}  // namespace sturm::stress
