#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/ellipses/accuracy_split.h"
#include "compare/ellipses/ellipse_comparison.h"
#include "compare/studies/sin2/closed_forms.h"
#include "conoid/tracing/footprint.h"
#include "experiments/sin2_study/pupil_trace.h"
#include "experiments/sin2_study/sin2_study.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"
#include "stages/ray_bundle.h"

namespace sturm {

namespace {

/// Two rules with n/2 and n angles that differ by more than this do not resolve the pattern: their error falls as ρⁿ,
/// so that of the finer one is about its square, 1e-10.
constexpr double resolved = 1e-5;

/// A principal difference below this [D] is rounding of a round eye seen through its vertex distance.
constexpr double least_cylinder_D = 1e-9;

/// The wavefront's truth about one eye, target, pupil and state.
struct View {
  Eye eye;
  double accommodation_D, target_vergence_D;
  Eigen::Matrix2d vergence;  ///< V = I/d + F − A·I
  PrincipalValues principal;
  Eigen::Matrix2d truth;  ///< covariance [rad²]
  Ellipse truth_ellipse;
};

View view_of(const Eye& eye, double distance_m) {
  View v;
  v.eye = eye;
  v.target_vergence_D = vergence_of(distance_m);
  v.accommodation_D = eye.accommodation_for(v.target_vergence_D);
  v.vergence = naked_eye_footprint(eye, distance_m, v.accommodation_D).angular;
  v.principal = principal_values(v.vergence(0, 0), v.vergence(0, 1), v.vergence(1, 1));
  v.truth = covariance_of_disc_image(v.vergence, eye.pupil_radius_m);
  v.truth_ellipse = Ellipse::image_of_disc(v.vergence, eye.pupil_radius_m);
  return v;
}

/// The closed form of the sin² pattern with a coefficient that is wrong on purpose: (4V₁² + 2V₁V₂ + V₂²)/8, and so for
/// the other axis.
Eigen::Matrix2d wrong_sin2_covariance(const View& v) {
  const double h = v.principal.high, l = v.principal.low, quarter = 0.25 * v.eye.pupil_radius_m * v.eye.pupil_radius_m;
  const Eigen::Matrix2d axis = v.principal.high_direction * v.principal.high_direction.transpose();
  return quarter / 8.0 *
         ((4.0 * h * h + 2.0 * h * l + l * l) * axis +
          (h * h + 2.0 * h * l + 4.0 * l * l) * (Eigen::Matrix2d::Identity() - axis));
}

Eigen::Matrix2d mirrored_truth(const View& v) {
  // Left and right exchanged: xy changes its sign.
  Eigen::Matrix2d m = v.truth;
  m(0, 1) = m(1, 0) = -m(0, 1);
  return m;
}

void add_principal_variances(StudyCase& c, const View& v, const Eigen::Matrix2d& measured) {
  const Eigen::Vector2d& u = v.principal.high_direction;
  const double cylinder = v.principal.high - v.principal.low, a = v.eye.pupil_radius_m;
  if (cylinder < least_cylinder_D) return;
  const double true_high = u.dot(v.truth * u), true_low = v.truth.trace() - true_high;
  const double high = u.dot(measured * u), low = measured.trace() - high;
  // At a circle of least confusion both differences are zero, and their ratio means nothing.
  if (std::abs(true_high - true_low) > 1e-3 * (true_high + true_low))
    c[StudyQuantity::difference_ratio] = (high - low) / (true_high - true_low);
  c[StudyQuantity::lost_variance_ratio] = (v.truth.trace() - measured.trace()) / (a * a * cylinder * cylinder / 16.0);
}

void add_samplings(StudyCase& c, const View& v, const EyeRays<double>& rays, const StudyPupils& pupils,
                   const Eigen::Matrix2d& uniform) {
  const double variance = uniform.trace();
  if (!(variance > 0.0)) return;
  const auto rms = [&](const std::vector<WeightedPoint>& points) -> std::optional<double> {
    const TracedPupil pupil = traced(rays, points, v.target_vergence_D);
    return pupil.covariance ? std::optional(std::sqrt(pupil.covariance->trace() / variance)) : std::nullopt;
  };
  c[StudyQuantity::polar_rms] = rms(pupils.polar);
  c[StudyQuantity::weighted_rms] = rms(pupils.polar_weighted);
  c[StudyQuantity::rings_rms] = rms(pupils.rings);
}

/// Euler's theorem: the power along a meridian is what sin² takes it for.
double largest_radial_deviation(const View& v, const EyeRays<double>& sin2, const StudyPupils& pupils) {
  const EyeRays<double> matrix(RayModel::power_matrix, v.eye, v.accommodation_D);
  double largest = 0.0;
  for (const WeightedPoint& node : pupils.uniform_disk) {
    const Eigen::Vector2d p = sin2.pupil_radius() * node.point;
    const PupilRay<double> is = sin2.through(p.x(), p.y()), should = matrix.through(p.x(), p.y());
    largest =
        std::max(largest, std::abs(p.dot(Eigen::Vector2d(is.sx - should.sx, is.sy - should.sy))) / p.squaredNorm());
  }
  return largest;
}

/// The model's own closed form, or theory itself for power_matrix.
std::optional<Eigen::Matrix2d> closed_form(const View& v, RayModel model) {
  const double a = v.eye.pupil_radius_m;
  if (model == RayModel::sin2_radial) return sin2_closed_form_covariance(v.vergence, a);
  if (model == RayModel::power_matrix) return v.truth;
  return metalstigmatism_covariance(v.eye.correction.matrix(), v.target_vergence_D,
                                    v.eye.stated_focus_distance_m().value(), a);
}

void add_mutants(StudyCase& c, const View& v, const EyeRays<double>& rays, const StudyPupils& pupils,
                 const Eigen::Matrix2d& measured) {
  const double a = v.eye.pupil_radius_m;
  if (c.model == RayModel::power_matrix)
    c[StudyQuantity::mutant_mirrored_axis] = relative_deviation(measured, mirrored_truth(v), a);
  if (c.model != RayModel::sin2_radial) return;
  const TangentialTerm tangential(v.eye.correction);
  const Eigen::Matrix2d repaired = *traced(rays, pupils.uniform_disk, v.target_vergence_D, &tangential).covariance;
  c[StudyQuantity::repaired_deviation] = relative_deviation(repaired, v.truth, a);
  c[StudyQuantity::mutant_repaired_as_sin2] = relative_deviation(repaired, *closed_form(v, c.model), a);
  c[StudyQuantity::mutant_wrong_coefficient] = relative_deviation(measured, wrong_sin2_covariance(v), a);
  c[StudyQuantity::mutant_sin2_as_matrix] = relative_deviation(measured, v.truth, a);
}

void measure(StudyCase& c, const View& v, const StudyPupils& pupils) {
  c[StudyQuantity::high_D] = v.principal.high;
  c[StudyQuantity::low_D] = v.principal.low;
  c[StudyQuantity::true_major_arcmin] = arcminutes_per_radian * v.truth_ellipse.semi_major;
  c[StudyQuantity::true_minor_arcmin] = arcminutes_per_radian * v.truth_ellipse.semi_minor;
  const auto rays = eye_rays_for(c.model, v.eye, v.accommodation_D);
  if (!rays) {
    c.status = StudyStatus::undefined;
    return;
  }
  const TracedPupil uniform = traced(*rays, pupils.uniform_disk, v.target_vergence_D);
  c[StudyQuantity::rays] = static_cast<double>(uniform.counters.launched);
  c[StudyQuantity::rays_dropped] = static_cast<double>(uniform.counters.dropped);
  c[StudyQuantity::rays_negative_focus] = static_cast<double>(uniform.counters.negative_focus);
  const double a = v.eye.pupil_radius_m;
  if (c.model == RayModel::metalstigmatism) {
    const TracedPupil half = traced(*rays, pupils.every_second, v.target_vergence_D);
    if (has_pole(v.eye.correction.matrix(), *v.eye.stated_focus_distance_m()) || !uniform.covariance ||
        !half.covariance || relative_deviation(*half.covariance, *uniform.covariance, a) > resolved) {
      c.status = StudyStatus::pole;
      return;
    }
  }
  const Eigen::Matrix2d& measured = *uniform.covariance;
  const Ellipse ellipse = Ellipse::of_second_moments(measured);
  c[StudyQuantity::major_arcmin] = arcminutes_per_radian * ellipse.semi_major;
  c[StudyQuantity::minor_arcmin] = arcminutes_per_radian * ellipse.semi_minor;
  const double error = covariance_error(measured, v.truth).half_width;
  c[StudyQuantity::error_D] = error / a;
  c[StudyQuantity::error_arcmin] = arcminutes_per_radian * error;
  if (v.truth_ellipse.semi_major > 0.0) c[StudyQuantity::error_percent] = 100.0 * error / v.truth_ellipse.semi_major;
  c[StudyQuantity::theory_deviation] = relative_deviation(measured, v.truth, a);
  if (const auto expected = closed_form(v, c.model))
    c[StudyQuantity::closed_form_deviation] = relative_deviation(measured, *expected, a);
  if (c.model == RayModel::sin2_radial) {
    c[StudyQuantity::radial_deviation_D] = largest_radial_deviation(v, *rays, pupils);
    add_principal_variances(c, v, measured);
  }
  add_samplings(c, v, *rays, pupils, measured);
  add_mutants(c, v, *rays, pupils, measured);
}

std::vector<Json> rows_of_eye(const Sin2StudySpec& spec, const StudyPupils& pupils, std::size_t eye) {
  std::vector<Json> rows;
  for (std::size_t accommodation = 0; accommodation < spec.accommodations.size(); ++accommodation)
    for (std::size_t pupil = 0; pupil < spec.pupil_diameters_m.size(); ++pupil) {
      const Eye worn =
          Eye::with(spec.eyes[eye].prescription, spec.pupil_diameters_m[pupil], spec.accommodations[accommodation]);
      for (std::size_t distance = 0; distance < spec.distances_m.size(); ++distance) {
        const View view = view_of(worn, spec.distances_m[distance]);
        for (const RayModel model : study_models) {
          StudyCase c{eye, distance, pupil, accommodation, model, StudyStatus::ok, {}};
          measure(c, view, pupils);
          rows.push_back(row_of(c));
        }
      }
    }
  return rows;
}

}  // namespace

Json sin2_study_rows(const Sin2StudySpec& spec, const StudyEyeGroup& group, const ProgressFunction& progress) {
  const StudyPupils pupils(spec);
  const std::size_t eyes = group.end - group.begin;
  std::vector<std::vector<Json>> results(eyes);
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, eyes, [&](std::size_t i) {
    results[i] = rows_of_eye(spec, pupils, group.begin + i);
    progress(static_cast<double>(++done) / static_cast<double>(eyes));
  });
  Json rows = Json::array();
  for (std::vector<Json>& of_eye : results)
    for (Json& row : of_eye) rows.push_back(std::move(row));
  return rows;
}

}  // namespace sturm
