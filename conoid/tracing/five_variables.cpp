#include "conoid/tracing/five_variables.h"

#include <Eigen/Geometry>
#include <cmath>

#include "lensmodel/symmetric2.h"

namespace sturm {

namespace {

/// Curvatures along two perpendicular directions and the twist between them: the second fundamental form in scalars.
struct Form {
  double along1, along2, twist;
};

Form form_on(const PrincipalCurvatures& c, const Eigen::Vector3d& f1, const Eigen::Vector3d& f2) {
  const double a = f1.dot(c.e1), b = f1.dot(c.e2), p = f2.dot(c.e1), q = f2.dot(c.e2);
  return {a * a * c.kappa1 + b * b * c.kappa2, p * p * c.kappa1 + q * q * c.kappa2,
          a * p * c.kappa1 + b * q * c.kappa2};
}

/// Turns the frame by the angle ω, tan 2ω = 2 κ_uv/(κ_u − κ_v), at which the twist vanishes.
FiveVariables principal(const Eigen::Vector3d& direction, const Form& form, const Eigen::Vector3d& u,
                        const Eigen::Vector3d& v) {
  const double omega = 0.5 * std::atan2(2.0 * form.twist, form.along1 - form.along2), c = std::cos(omega),
               s = std::sin(omega);
  const double kappa1 = c * c * form.along1 + 2.0 * c * s * form.twist + s * s * form.along2;
  const double kappa2 = s * s * form.along1 - 2.0 * c * s * form.twist + c * c * form.along2;
  return {direction, kappa1, kappa2, c * u + s * v, c * v - s * u};
}

double transferred(double kappa, double d) {
  if (std::isinf(kappa)) return d == 0.0 ? kappa : -1.0 / d;
  return kappa / (1.0 - d * kappa);
}

FiveVariables behind(const FiveVariables& wave, const Eigen::Vector3d& normal, const PrincipalCurvatures& surface,
                     double mu, double cos_in, double cos_out) {
  const double gamma = cos_out - mu * cos_in;
  const Eigen::Vector3d direction = (mu * wave.direction + gamma * normal).normalized(),
                        across = wave.direction.cross(normal);
  const Eigen::Vector3d u = across.norm() < 1e-9 ? wave.e1 : Eigen::Vector3d(across.normalized());
  const Eigen::Vector3d v = wave.direction.cross(u), v_out = direction.cross(u), tangent = normal.cross(u);
  const Form in = form_on({wave.kappa1, wave.kappa2, wave.e1, wave.e2}, u, v), s = form_on(surface, u, tangent);
  const Form out{mu * in.along1 + gamma * s.along1,
                 (mu * cos_in * cos_in * in.along2 + gamma * s.along2) / (cos_out * cos_out),
                 (mu * cos_in * in.twist + gamma * s.twist) / cos_out};
  return principal(direction, out, u, v_out);
}

}  // namespace

FiveVariables transferred(const FiveVariables& wave, double distance) {
  FiveVariables moved = wave;
  moved.kappa1 = transferred(wave.kappa1, distance);
  moved.kappa2 = transferred(wave.kappa2, distance);
  return moved;
}

std::optional<FiveVariables> refracted(const FiveVariables& wave, const Eigen::Vector3d& normal,
                                       const PrincipalCurvatures& surface, double index_before, double index_behind) {
  const double mu = index_before / index_behind, cos_in = wave.direction.dot(normal);
  const double square = 1.0 - mu * mu * (1.0 - cos_in * cos_in);
  if (!(square > 0.0)) return std::nullopt;
  return behind(wave, normal, surface, mu, cos_in, std::sqrt(square));
}

FiveVariables reflected(const FiveVariables& wave, const Eigen::Vector3d& normal, const PrincipalCurvatures& surface) {
  const double cos_in = wave.direction.dot(normal);
  return behind(wave, normal, surface, 1.0, cos_in, -cos_in);
}

FiveVariables through_thin_lens(const FiveVariables& wave, const PrincipalCurvatures& power) {
  const Form in{wave.kappa1, wave.kappa2, 0.0}, p = form_on(power, wave.e1, wave.e2);
  return principal(wave.direction, {in.along1 + p.along1, in.along2 + p.along2, in.twist + p.twist}, wave.e1, wave.e2);
}

PrincipalCurvatures principal_curvatures(const Eigen::Matrix2d& k, const Eigen::Vector3d& f1,
                                         const Eigen::Vector3d& f2) {
  const PrincipalValues p = principal_values(k(0, 0), k(0, 1), k(1, 1));
  const Eigen::Vector2d& h = p.high_direction;
  return {p.high, p.low, h.x() * f1 + h.y() * f2, -h.y() * f1 + h.x() * f2};
}

}  // namespace sturm
