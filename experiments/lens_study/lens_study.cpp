#include "experiments/lens_study/lens_study.h"

#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cmath>

#include "compare/ellipses/accuracy_split.h"
#include "conoid/tracing/previous.h"
#include "conoid/tracing/published.h"
#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/gaze.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"
#include "stages/ray_bundle.h"

namespace sturm {

namespace {

/// A direction of sight by its angle from the lens's axis and its direction about it.
struct StudyGaze {
  double eccentricity_deg;
  std::optional<double> direction_deg;  ///< none straight ahead

  Eigen::Vector3d vector() const {
    const SineCosine away = sine_cosine_of_degrees(eccentricity_deg),
                     about = sine_cosine_of_degrees(direction_deg.value_or(0.0));
    return {away.sine * about.cosine, away.sine * about.sine, -away.cosine};
  }
};

std::vector<StudyGaze> gazes_of(const LensStudySpec& spec) {
  std::vector<StudyGaze> gazes;
  for (const double eccentricity : spec.eccentricities_deg) {
    if (eccentricity == 0.0) {
      gazes.push_back({0.0, std::nullopt});
      continue;
    }
    for (const double direction : spec.directions_deg) gazes.push_back({eccentricity, direction});
  }
  return gazes;
}

/// One eye looking through its lens along one line of sight, traced by every method for all distances and pupils.
struct Sight {
  Eye eye;
  double accommodation_D;
  Eigen::Vector3d gaze;
  SpectacleConoid conoid;
  std::optional<LensView> lens;             ///< where the chief ray comes through
  std::array<PublishedTrace, 2> published;  ///< by TangentAxes::principal and ::incidence
  std::optional<PreviousMethod> previous;

  /// F − A·I.
  Eigen::Matrix2d slopes() const { return eye.slope_matrix(accommodation_D).matrix(); }

  /// Maps X/d [rad/m] of the methods on the conoid's axes across the outgoing chief ray.
  Eigen::Matrix2d exact(double vergence_D) const { return conoid.angular_footprint(slopes(), vergence_D); }
  std::optional<Eigen::Matrix2d> as_published(double vergence_D) const {
    if (!published[0].conoid) return std::nullopt;
    return angular_map(*published[0].conoid, conoid.exit.e1, conoid.exit.e2, vergence_D);
  }
  std::optional<PreviousBlur> by_previous(double vergence_D) const { return previous->blur(slopes(), vergence_D); }
};

Sight sight_of(const LensStudySpec& spec, const StudyLens& lens, const Eigen::Vector3d& gaze) {
  Sight s;
  s.eye = Eye::with(lens.prescription, 2.0 * spec.pupil_diameters_m.front(), spec.accommodation);
  s.eye.rotation_center_m = spec.rotation_center_m;
  s.accommodation_D = s.eye.accommodation_for(0.0);  // relaxed or fixed: the same for every target
  s.gaze = gaze;
  s.conoid = trace_conoid(lens.lens, gaze, spec.rotation_center_m);
  if (s.conoid.status != LensStatus::ok) return s;
  s.lens = LensView::along(lens.lens, gaze, spec.rotation_center_m);
  s.published = {trace_published_or_why(s.eye, s.accommodation_D, &lens.lens, gaze, TangentAxes::principal),
                 trace_published_or_why(s.eye, s.accommodation_D, &lens.lens, gaze, TangentAxes::incidence)};
  s.previous.emplace(&lens.lens, gaze, spec.rotation_center_m);
  return s;
}

/// Second moments [rad²] of the real rays through a pupil; none where any ray was lost, since the rest is another
/// pupil.
struct RealRays {
  std::optional<Eigen::Matrix2d> covariance;
  std::uint64_t lost = 0;
};

RealRays real_rays(const Sight& sight, const QuadratureSpec& rule, double vergence_D, double pupil_radius_m) {
  Eye eye = sight.eye;
  eye.pupil_radius_m = pupil_radius_m;
  RayBundleSpec rays;
  rays.quadrature = rule;
  const MeasuredBundle bundle = measure_bundle(EyeRays<double>(RayModel::power_matrix, eye, sight.accommodation_D),
                                               vergence_D, rays, 0, &*sight.lens);
  RealRays result{std::nullopt, bundle.losses.total()};
  if (result.lost == 0 && bundle.angular) result.covariance = bundle.angular->covariance;
  return result;
}

bool of_revolution(const Surface& surface) {
  return std::holds_alternative<SphereSurface>(surface) || std::holds_alternative<ConicSurface>(surface);
}

bool of_revolution(const Spectacles& lens) {
  return of_revolution(lens.front) && of_revolution(lens.back) && lens.mounting.straight() &&
         !lens.mounting.has_wedge();
}

/// Splines have jumps in their third derivative: where a knot lies in the pupil's footprint no power of the pupil is
/// exact.
bool analytic(const Spectacles& lens) {
  return !std::holds_alternative<BSplineSurface>(lens.front) && !std::holds_alternative<BSplineSurface>(lens.back);
}

const char* word_for(Eq11Failure failure) {
  switch (failure) {
    case Eq11Failure::no_length:
      return "no_length";
    case Eq11Failure::singular:
      return "singular";
    default:
      return "negative";
  }
}

const char* word_for(const PublishedTrace& trace) {
  if (trace.conoid) return trace.free_axes ? "free_axes" : "ok";
  return trace.failure ? word_for(*trace.failure) : "lost";
}

/// An error against `should` at one pupil, in the units that are of use: arcmin and dioptres.
MethodError method_error(const Eigen::Matrix2d& is, const Eigen::Matrix2d& should, double pupil_radius_m) {
  const CovarianceError e = covariance_error(is, should);
  return {.relative_frobenius = e.relative_frobenius,
          .semi_axes_arcmin = {arcminutes_per_radian * e.semi_axes.x(), arcminutes_per_radian * e.semi_axes.y()},
          .half_width_arcmin = arcminutes_per_radian * e.half_width,
          .defocus_D = e.half_width / pupil_radius_m};
}

/// A method's first order against the exact one: the same at every pupil, so for a pupil of unit radius.
std::optional<FirstOrderError> first_order_error(const std::optional<Eigen::Matrix2d>& map,
                                                 const Eigen::Matrix2d& exact) {
  if (!map) return std::nullopt;
  const CovarianceError e = covariance_error(covariance_of_disc_image(*map, 1.0), covariance_of_disc_image(exact, 1.0));
  return FirstOrderError{e.relative_frobenius, e.half_width};
}

/// How far the previous method is from the exact first order once its scaling to the object is replaced by the true
/// one, Q.
Number unscaled_error(const Sight& sight, const std::optional<PreviousBlur>& previous, const Eigen::Matrix2d& exact,
                      double vergence_D) {
  if (!previous) return std::nullopt;
  const Eigen::Matrix2d q = sight.conoid.angular_q(vergence_D);
  // Against the size of what the footprint is the difference of, where the blur itself nearly vanishes.
  return (q * previous->inside - exact).norm() / (exact.norm() + q.norm());
}

/// What the same pair of covariances says about footprints that are wrong on purpose.
MutantOrders mutant_orders(const Sight& sight, const Eigen::Matrix2d& mirrored, double vergence_D,
                           const Eigen::Matrix2d& small, double small_radius_m, const Eigen::Matrix2d& large,
                           double large_radius_m) {
  const auto order = [&](const std::optional<Eigen::Matrix2d>& x) -> Number {
    return x ? Number(fit_orders(*x, small, small_radius_m, large, large_radius_m).absolute) : std::nullopt;
  };
  return {.published_as_exact = order(sight.as_published(vergence_D)), .mirrored_gaze = order(mirrored)};
}

/// One pupil of a view: the methods' maps against the real rays.
LensPupil pupil_of(double pupil_diameter_m, const RealRays& rays, const Eigen::Matrix2d& exact,
                   const std::optional<Eigen::Matrix2d>& published, const std::optional<Eigen::Matrix2d>& previous) {
  const double a = 0.5 * pupil_diameter_m;
  const auto against_rays = [&](const std::optional<Eigen::Matrix2d>& map) {
    return map && rays.covariance ? std::optional(method_error(covariance_of_disc_image(*map, a), *rays.covariance, a))
                                  : std::nullopt;
  };
  LensPupil pupil{.pupil_mm = 1e3 * pupil_diameter_m,
                  .rays_lost = static_cast<std::int64_t>(rays.lost),
                  .ray_transfer = against_rays(exact),
                  .published = against_rays(published),
                  .previous = against_rays(previous)};
  if (rays.covariance) {
    const Ellipse e = Ellipse::of_second_moments(*rays.covariance);
    pupil.real_semi_axes_arcmin = {arcminutes_per_radian * e.semi_major, arcminutes_per_radian * e.semi_minor};
  }
  return pupil;
}

LensStudyView view_of(const LensStudySpec& spec, const Sight& sight, const SpectacleConoid& mirrored,
                      double distance_m) {
  const double vergence = vergence_of(distance_m);
  const Eigen::Matrix2d exact = sight.exact(vergence);
  const std::optional<Eigen::Matrix2d> published = sight.as_published(vergence);
  const auto blur_inside = sight.by_previous(vergence);
  const std::optional<Eigen::Matrix2d> previous = blur_inside ? std::optional(blur_inside->angular()) : std::nullopt;
  const SingularValues blur = singular_values(exact);
  LensStudyView view;
  view.distance_m = StoredDistance{distance_m};
  view.blur_D = {blur.large, blur.small};
  view.first_order = {first_order_error(published, exact), first_order_error(previous, exact)};
  view.previous_unscaled_error = unscaled_error(sight, blur_inside, exact, vergence);
  std::optional<Eigen::Matrix2d> small, large;
  for (const double diameter : spec.pupil_diameters_m) {
    const RealRays rays = real_rays(sight, spec.quadrature, vergence, 0.5 * diameter);
    if (diameter == spec.order_small_m) small = rays.covariance;
    if (diameter == spec.order_large_m) large = rays.covariance;
    view.pupils.push_back(pupil_of(diameter, rays, exact, published, previous));
  }
  if (!small || !large) return view;
  const OrderFit fit = fit_orders(exact, *small, 0.5 * spec.order_small_m, *large, 0.5 * spec.order_large_m);
  view.order = fit.absolute;
  view.relative_order = fit.relative;
  view.limit_relative = fit.limit_relative;
  if (mirrored.status == LensStatus::ok)
    view.mutant_orders = mutant_orders(sight, mirrored.angular_footprint(sight.slopes(), vergence), vergence, *small,
                                       0.5 * spec.order_small_m, *large, 0.5 * spec.order_large_m);
  return view;
}

struct GazeResult {
  LensGaze gaze;
  std::vector<LensStudyView> views;
};

GazeResult gaze_result(const LensStudySpec& spec, const StudyLens& lens, const StudyGaze& gaze) {
  const Eigen::Vector3d direction = gaze.vector();
  const Sight sight = sight_of(spec, lens, direction);
  const SpectacleConoid mirrored =
      trace_conoid(lens.lens, {-direction.x(), direction.y(), direction.z()}, spec.rotation_center_m);
  GazeResult result{{.lens = lens.id,
                     .eccentricity_deg = gaze.eccentricity_deg,
                     .direction_deg = gaze.direction_deg,
                     .gaze_deg = {std::atan2(direction.x(), -direction.z()) / radians_per_degree,
                                  std::asin(direction.y()) / radians_per_degree},
                     .status = name_of(sight.conoid.status)},
                    {}};
  if (sight.conoid.status != LensStatus::ok) return result;
  result.gaze.eq11 = Eq11Outcome{word_for(sight.published[0]), word_for(sight.published[1])};
  for (const double distance : spec.distances_m) {
    LensStudyView view = view_of(spec, sight, mirrored, distance);
    view.lens = lens.id;
    view.eccentricity_deg = gaze.eccentricity_deg;
    view.direction_deg = gaze.direction_deg;
    result.views.push_back(std::move(view));
  }
  return result;
}

std::optional<FieldEllipse> field_ellipse(const std::optional<Eigen::Matrix2d>& covariance) {
  if (!covariance) return std::nullopt;
  const Ellipse e = Ellipse::of_second_moments(*covariance);
  return FieldEllipse{{arcminutes_per_radian * e.semi_major, arcminutes_per_radian * e.semi_minor}, e.orientation_deg};
}

}  // namespace

LensPart lens_study_of(const LensStudySpec& spec, const StudyLens& lens, const ProgressFunction& progress) {
  const std::vector<StudyGaze> gazes = gazes_of(spec);
  std::vector<GazeResult> results(gazes.size());
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, gazes.size(), [&](std::size_t i) {
    results[i] = gaze_result(spec, lens, gazes[i]);
    progress(static_cast<double>(++done) / static_cast<double>(gazes.size()));
  });
  const Prescription& rx = lens.prescription;
  LensPart part;
  part.lens = {.id = lens.id,
               .note = lens.note,
               .lens_of_revolution = of_revolution(lens.lens),
               .analytic_surfaces = analytic(lens.lens),
               .sphere_D = rx.sphere_D,
               .cylinder_D = rx.cylinder_D,
               .axis_deg = rx.axis_deg,
               .vertex_distance_mm = 1e3 * rx.vertex_distance_m};
  for (GazeResult& result : results) {
    part.gazes.push_back(std::move(result.gaze));
    for (LensStudyView& view : result.views) part.views.push_back(std::move(view));
  }
  return part;
}

LensField wide_gaze_study(const LensStudySpec& spec, const WideGaze& gaze) {
  const StudyLens& lens = spec.lenses[gaze.lens];
  const double vergence = vergence_of(gaze.distance_m), a = 0.5 * gaze.pupil_diameter_m;
  LensField field{.lens = lens.id, .distance_m = StoredDistance{gaze.distance_m}, .pupil_mm = 2e3 * a, .points = {}};
  for (const double azimuth : gaze.azimuths_deg) {
    const Sight sight = sight_of(spec, lens, gaze_direction(azimuth * radians_per_degree, 0.0));
    FieldPoint point{.azimuth_deg = azimuth, .status = name_of(sight.conoid.status)};
    if (sight.conoid.status == LensStatus::ok) {
      const auto covariance = [a](const std::optional<Eigen::Matrix2d>& map) {
        return map ? std::optional(covariance_of_disc_image(*map, a)) : std::nullopt;
      };
      point.real_rays = field_ellipse(real_rays(sight, spec.quadrature, vergence, a).covariance);
      point.ray_transfer = field_ellipse(covariance(sight.exact(vergence)));
      point.published = field_ellipse(covariance(sight.as_published(vergence)));
      const auto previous = sight.by_previous(vergence);
      point.previous = field_ellipse(covariance(previous ? std::optional(previous->angular()) : std::nullopt));
    }
    field.points.push_back(std::move(point));
  }
  return field;
}

}  // namespace sturm
