#include "conoid/tracing/published.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "conoid/tracing/interface.h"
#include "lensmodel/gaze.h"
#include "lensmodel/symmetric2.h"

namespace sturm {

namespace {

/// Below this determinant eq. 11 has lost all but a few digits.
constexpr double smallest_determinant = 1e-6;

/// A difference of principal curvatures below this share of what it is the difference of is rounding.
constexpr double relative_isotropy = 1e-10;

/// A section whose semi-axes differ by less than this share is a circle and may have any axes.
constexpr double relative_roundness = 1e-10;

bool is_circle(const PublishedConoid& c) {
  return std::abs(std::abs(c.epsilon1) - std::abs(c.epsilon2)) <=
         relative_roundness * std::max(std::abs(c.epsilon1), std::abs(c.epsilon2));
}

PublishedConoid transferred(const PublishedConoid& c, double distance) {
  return {transferred(c.wave, distance), (1.0 - distance * c.wave.kappa1) * c.epsilon1,
          (1.0 - distance * c.wave.kappa2) * c.epsilon2};
}

std::optional<PublishedConoid> through(const PublishedConoid& c, const SurfaceElement& surface, double index_before,
                                       double index_behind, TangentAxes tangent, PublishedTrace& trace) {
  const Eigen::Vector3d normal = surface.normal, t1 = normal.unitOrthogonal(), t2 = normal.cross(t1);
  const PrincipalCurvatures bend = principal_curvatures(tangent_curvature(surface, t1, t2), t1, t2);
  auto wave = refracted(c.wave, normal, bend, index_before, index_behind);
  if (!wave) return std::nullopt;
  const double size = std::abs(c.wave.kappa1) + std::abs(c.wave.kappa2) + std::abs(bend.kappa1) + std::abs(bend.kappa2);
  if (std::abs(wave->kappa1 - wave->kappa2) <= relative_isotropy * size && !is_circle(c)) {
    trace.free_axes = true;
    wave->e1 = (c.wave.e1 - c.wave.e1.dot(wave->direction) * wave->direction).normalized();
    wave->e2 = wave->direction.cross(wave->e1);
  }
  // Keep the numbers: e'₁ is the one that continues e₁.
  if (std::abs(wave->e1.dot(c.wave.e1)) < std::abs(wave->e2.dot(c.wave.e1))) {
    std::swap(wave->kappa1, wave->kappa2);
    std::swap(wave->e1, wave->e2);
  }
  Eq11Failure why{};
  const auto axes = refracted_semi_axes({c.epsilon1, c.epsilon2}, c.wave, *wave, normal, tangent, &why);
  if (!axes) {
    trace.failure = why;
    return std::nullopt;
  }
  return PublishedConoid{*wave, axes->first, axes->second};
}

}  // namespace

std::optional<SemiAxes> refracted_semi_axes(const SemiAxes& axes, const FiveVariables& before,
                                            const FiveVariables& behind, const Eigen::Vector3d& normal,
                                            TangentAxes tangent, Eq11Failure* why) {
  const auto fails_as = [why](Eq11Failure failure) {
    if (why) *why = failure;
    return std::nullopt;
  };
  Eigen::Vector3d x = tangent == TangentAxes::incidence ? before.direction.cross(normal) : behind.e1;
  x -= x.dot(normal) * normal;
  if (x.norm() < 1e-9) x = behind.e1 - behind.e1.dot(normal) * normal;  // normal incidence: any axes
  x.normalize();
  const Eigen::Vector3d y = normal.cross(x);
  const auto squared = [](const Eigen::Vector3d& e, const Eigen::Vector3d& axis) { return e.dot(axis) * e.dot(axis); };
  if (axes.first == 0.0 || axes.second == 0.0) return fails_as(Eq11Failure::no_length);
  const double e1 = 1.0 / (axes.first * axes.first), e2 = 1.0 / (axes.second * axes.second);
  const double xx = squared(before.e1, x) * e1 + squared(before.e2, x) * e2,
               yy = squared(before.e1, y) * e1 + squared(before.e2, y) * e2;
  const double a = squared(behind.e1, x), b = squared(behind.e2, x), c = squared(behind.e1, y),
               d = squared(behind.e2, y);
  const double determinant = a * d - b * c;
  if (!(std::abs(determinant) > smallest_determinant)) return fails_as(Eq11Failure::singular);
  const double first = (d * xx - b * yy) / determinant, second = (a * yy - c * xx) / determinant;
  if (!(first > 0.0 && second > 0.0)) return fails_as(Eq11Failure::negative);
  return SemiAxes{std::copysign(1.0 / std::sqrt(first), axes.first),
                  std::copysign(1.0 / std::sqrt(second), axes.second)};
}

PublishedTrace trace_published_or_why(const Eye& eye, double accommodation_D, const Spectacles* lens,
                                      const Eigen::Vector3d& gaze, TangentAxes tangent) {
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  const PrincipalCurvatures start =
      principal_curvatures(-eye.slope_matrix(accommodation_D).matrix(), turn.col(0), turn.col(1));
  const PublishedConoid pupil{
      {gaze, start.kappa1, start.kappa2, start.e1, start.e2}, 1.0, 1.0};  // eq. 9 in units of a: eqs. 10–12 scale
  if (!lens) return {pupil, std::nullopt};
  const Eigen::Vector3d center = turned_pupil_center(gaze, eye.rotation_center_m);
  const LensPath path = trace(*lens, {center, gaze});
  PublishedTrace result;
  if (path.status != LensStatus::ok) return result;
  const auto inside = through(transferred(pupil, (path.back_point - center).norm()), path.back, 1.0,
                              lens->refractive_index, tangent, result);
  if (!inside) return result;
  result.conoid = through(transferred(*inside, (path.exit.origin - path.back_point).norm()), path.front,
                          lens->refractive_index, 1.0, tangent, result);
  return result;
}

std::optional<PublishedConoid> trace_published(const Eye& eye, double accommodation_D, const Spectacles* lens,
                                               const Eigen::Vector3d& gaze, TangentAxes tangent) {
  return trace_published_or_why(eye, accommodation_D, lens, gaze, tangent).conoid;
}

Eigen::Matrix2d angular_map(const PublishedConoid& c, const Eigen::Vector3d& f1, const Eigen::Vector3d& f2,
                            double vergence_D) {
  const Eigen::Vector2d p(c.wave.e1.dot(f1), c.wave.e1.dot(f2)), q(c.wave.e2.dot(f1), c.wave.e2.dot(f2));
  return (vergence_D - c.wave.kappa1) * c.epsilon1 * p * p.transpose() +
         (vergence_D - c.wave.kappa2) * c.epsilon2 * q * q.transpose();
}

PublishedAccommodation mixed(const Eigen::Matrix2d& relaxed, const Eigen::Matrix2d& tense) {
  const double difference = relaxed.trace() - tense.trace();
  const double t = difference != 0.0 ? std::clamp(relaxed.trace() / difference, 0.0, 1.0) : 0.0;
  return {t, (1.0 - t) * relaxed + t * tense};
}

}  // namespace sturm
