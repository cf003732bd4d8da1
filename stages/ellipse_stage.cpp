#include "stages/ellipse_stage.h"

#include <cmath>
#include <optional>

#include "conoid/tracing/previous.h"
#include "conoid/tracing/published.h"
#include "conoid/tracing/turned_eye.h"
#include "io/json/values.h"
#include "lensmodel/focal_lines.h"
#include "lensmodel/gaze.h"
#include "lensmodel/tabo.h"
#include "lensmodel/units.h"
#include "pathtrace/sampling/pupil_sampler.h"
#include "stages/ray_bundle.h"

namespace sturm {

namespace {

/// One target as the turned eye sees it, through its spectacles if it has some.
struct View {
  double distance_m, vergence_D;
  TurnedEye eye;
  std::optional<double> accommodation_D;  ///< none where the chief ray is lost
  Eigen::Matrix3d turn;                   ///< takes primary axes to the turned pupil frame; Listing
  std::optional<LensView> lens;           ///< only with spectacles that the chief ray comes through

  const Eigen::Vector3d& gaze() const { return eye.line_of_sight().direction; }
};

View view_of(const Target& target, const EllipseQuery& query) {
  const Eigen::Vector3d gaze = gaze_direction(target.azimuth, target.elevation);
  const Spectacles* lens = query.spectacles ? &*query.spectacles : nullptr;
  View v{target.distance_m,
         vergence_of(target.distance_m),
         {query.eye, lens, gaze},
         std::nullopt,
         smallest_rotation({0.0, 0.0, -1.0}, gaze),
         std::nullopt};
  if (v.eye.status() != LensStatus::ok) return v;
  v.accommodation_D = v.eye.accommodation(v.vergence_D);
  if (lens) v.lens = LensView::along(*lens, gaze, query.eye.rotation_center_m);
  return v;
}

/// Nothing could be computed: all numbers are null.
void write_failure(Json& result, const std::string& status) {
  result["status"] = status;
  for (const char* key : {"semi_axes_m", "semi_axes_rad", "semi_axes_arcmin", "semi_axes_D", "orientation_deg",
                          "orientation_tabo_deg", "covariance_m2", "covariance_rad2", "centroid_m", "centroid_rad"})
    result[key] = nullptr;
}

/// A direction in the wearer frame as an examiner writes it.
Json tabo_json(const std::optional<double>& wearer_deg) {
  return wearer_deg ? number_or_null(tabo_deg(*wearer_deg)) : Json(nullptr);
}

/// Quantities at the target: in metres only where it is at a finite distance, as defocus only of a pupil with a size.
struct AtTarget {
  const View& view;
  double pupil_radius_m;

  bool finite() const { return !std::isinf(view.distance_m); }
  Json metres(Json (*write)(const Eigen::Matrix2d&), const Eigen::Matrix2d& angular, int power) const {
    if (!finite()) return nullptr;
    return write(std::pow(view.distance_m, power) * angular);
  }
  Json metres(const Eigen::Vector2d& angular) const {
    return finite() ? json_of(Eigen::Vector2d(view.distance_m * angular)) : Json(nullptr);
  }
  Json semi_axes(const Ellipse& angular) const {
    return finite() ? semi_axes_json(angular, view.distance_m) : Json(nullptr);
  }
  Json defocus(const Ellipse& angular) const {
    return pupil_radius_m > 0.0 ? semi_axes_json(angular, 1.0 / pupil_radius_m) : Json(nullptr);
  }
};

void write_ellipse(Json& result, const AtTarget& at, const Ellipse& ellipse, const Eigen::Matrix2d& covariance,
                   const Eigen::Vector2d& centroid) {
  result["semi_axes_m"] = at.semi_axes(ellipse);
  result["semi_axes_rad"] = semi_axes_json(ellipse);
  result["semi_axes_arcmin"] = semi_axes_json(ellipse, arcminutes_per_radian);
  result["semi_axes_D"] = at.defocus(ellipse);
  result["orientation_deg"] = number_or_null(ellipse.orientation_deg);
  result["orientation_tabo_deg"] = tabo_json(ellipse.orientation_deg);
  result["covariance_m2"] = at.metres(symmetric_json, covariance, 2);
  result["covariance_rad2"] = symmetric_json(covariance);
  result["centroid_m"] = at.metres(centroid);
  result["centroid_rad"] = json_of(centroid);
}

/// Where the wave that leaves the eye has no width, nearest first.
Json focal_lines_json(const Eigen::Matrix2d& wavefront_curvature) {
  Json lines = Json::array();
  for (const FocalLine& line : focal_lines(wavefront_curvature)) {
    const std::optional<double> distance_m = line.distance_m();
    lines.push_back({{"vergence_D", number_or_null(line.vergence_D)},
                     {"distance_m", distance_m ? distance_json(*distance_m) : Json(nullptr)},
                     {"orientation_deg", number_or_null(line.direction_deg)},
                     {"orientation_tabo_deg", tabo_json(line.direction_deg)}});
  }
  return lines;
}

void write_conoid(Json& result, const View& view, const Eye& eye) {
  const AtTarget at{view, eye.pupil_radius_m};
  const Footprint f = view.eye.footprint(view.distance_m, *view.accommodation_D);
  result["status"] = "ok";
  result["footprint"] = rows_json(at.finite() ? f.transverse() : f.angular);
  write_ellipse(result, at, Ellipse::image_of_disc(f.angular, eye.pupil_radius_m),
                covariance_of_disc_image(f.angular, eye.pupil_radius_m), Eigen::Vector2d::Zero());
  result["wavefront_curvature_D"] = f.wavefront_curvature ? symmetric_json(*f.wavefront_curvature) : Json(nullptr);
  result["focal_lines"] = f.wavefront_curvature ? focal_lines_json(*f.wavefront_curvature) : Json(nullptr);
}

/// A method that knows only an ellipse, as a map of the pupil divided by the distance [rad/m].
void write_map(Json& result, const View& view, const std::optional<Eigen::Matrix2d>& map, double pupil_radius_m) {
  if (!map) {
    write_failure(result, "undefined");
    return;
  }
  result["status"] = "ok";
  write_ellipse(result, AtTarget{view, pupil_radius_m}, Ellipse::image_of_disc(*map, pupil_radius_m),
                covariance_of_disc_image(*map, pupil_radius_m), Eigen::Vector2d::Zero());
}

/// Conoid tracing as printed; `best` accommodation by its own eq. 12.
void write_published(Json& result, const View& view, const EllipseQuery& query) {
  const Spectacles* lens = query.spectacles ? &*query.spectacles : nullptr;
  const Eigen::Matrix3d across = smallest_rotation({0.0, 0.0, -1.0}, view.eye.chief_ray().direction);
  const auto map = [&](double accommodation_D) -> std::optional<Eigen::Matrix2d> {
    const auto conoid = trace_published(query.eye, accommodation_D, lens, view.gaze());
    if (!conoid) return std::nullopt;
    return angular_map(*conoid, across.col(0), across.col(1), view.vergence_D);
  };
  const auto* best = std::get_if<BestAccommodation>(&query.eye.accommodation);
  if (!best) return write_map(result, view, map(*view.accommodation_D), query.eye.pupil_radius_m);
  const auto relaxed = map(0.0), tense = map(best->amplitude_D);
  result["accommodation_D"] = nullptr;
  if (!relaxed || !tense) return write_map(result, view, std::nullopt, 0.0);
  const PublishedAccommodation mix = mixed(*relaxed, *tense);
  result["accommodation_D"] = mix.t * best->amplitude_D;
  write_map(result, view, mix.map, query.eye.pupil_radius_m);
}

void write_previous(Json& result, const View& view, const EllipseQuery& query) {
  const Spectacles* lens = query.spectacles ? &*query.spectacles : nullptr;
  write_map(result, view,
            previous_angular_footprint(query.eye, *view.accommodation_D, lens, view.gaze(), view.distance_m),
            query.eye.pupil_radius_m);
}

void write_standard_errors(Json& result, const AtTarget& at, const BundleEllipse& e) {
  const auto covariance = e.covariance_standard_error();
  if (!covariance) {
    result["standard_error"] = nullptr;
    return;
  }
  const double d2 = at.view.distance_m * at.view.distance_m;
  Json& errors = result["standard_error"];
  errors["covariance_rel"] = number_or_null(e.covariance_rel());
  errors["covariance_rad2"] = json_of(*covariance);
  errors["covariance_m2"] = at.finite() ? json_of(Eigen::Vector3d(d2 * *covariance)) : Json(nullptr);
  if (const auto axes = e.semi_axis_standard_errors()) {
    errors["semi_axes_rad"] = json_of(*axes);
    errors["semi_axes_m"] = at.metres(*axes);
  }
  if (e.centroid_standard_error) errors["centroid_m"] = at.metres(*e.centroid_standard_error);
}

/// The ray that leaves the eye, or the spectacles, in the wearer frame of primary gaze; none if it is lost.
std::optional<LightRay> exit_ray(const View& view, const PupilRay<double>& ray) {
  if (ray.status == LaunchStatus::dropped) return std::nullopt;
  if (view.lens) {
    const LensPath path = view.lens->worn.path_of(ray);
    return path.status == LensStatus::ok ? std::optional(path.exit) : std::nullopt;
  }
  return LightRay{view.eye.line_of_sight().origin + view.turn * Eigen::Vector3d(ray.px, ray.py, 0.0),
                  (view.turn * Eigen::Vector3d(ray.sx, ray.sy, -1.0)).normalized()};
}

Json exit_rays(const View& view, const EyeRays<double>& rays, const std::vector<Eigen::Vector2d>& pupil_points) {
  Json list = Json::array();
  for (const Eigen::Vector2d& p : pupil_points) {
    const auto exit = exit_ray(view, rays.through(p.x(), p.y()));
    list.push_back(exit ? Json{{"exit_point_m", json_of(exit->origin)}, {"exit_direction", json_of(exit->direction)}}
                        : Json(nullptr));
  }
  return list;
}

/// Why a bundle has no ellipse: the most frequent reason, or `ok` for a single given ray.
std::string status_without_ellipse(const MeasuredBundle& bundle) {
  const LensLosses& lost = bundle.losses;
  if (lost.total() == 0 && bundle.counters.dropped == 0) return "ok";
  if (bundle.counters.dropped >= lost.total()) return "undefined";
  if (lost.rim >= lost.total_reflection && lost.rim >= lost.no_convergence) return name_of(LensStatus::missed_lens);
  return name_of(lost.total_reflection >= lost.no_convergence ? LensStatus::total_internal_reflection
                                                              : LensStatus::no_convergence);
}

void write_rays(Json& result, const View& view, const EllipseQuery& query, RayModel model) {
  const AtTarget at{view, query.eye.pupil_radius_m};
  const auto rays = eye_rays_for(model, query.eye, *view.accommodation_D);
  const MeasuredBundle bundle =
      rays ? measure_bundle(*rays, view.vergence_D, query.rays, query.seed, view.lens ? &*view.lens : nullptr,
                            apodization_of(query.eye.stiles_crawford_per_m2, query.eye.pupil_radius_m))
           : MeasuredBundle{};
  result["rays"] = {{"launched", bundle.counters.launched},       {"lost_rim", bundle.losses.rim},
                    {"lost_tir", bundle.losses.total_reflection}, {"lost_no_convergence", bundle.losses.no_convergence},
                    {"undefined", bundle.counters.dropped},       {"negative_focus", bundle.counters.negative_focus}};
  if (rays && !query.rays.pupil_points_m.empty())
    result["exit_rays"] = exit_rays(view, *rays, query.rays.pupil_points_m);
  if (!bundle.angular) {
    write_failure(result, rays ? status_without_ellipse(bundle) : "undefined");
    result["standard_error"] = nullptr;
    return;
  }
  result["status"] = "ok";
  write_ellipse(result, at, bundle.angular->ellipse, bundle.angular->covariance, bundle.angular->centroid);
  write_standard_errors(result, at, *bundle.angular);
}

/// One method's answer for one target.
Json result_of(const View& view, const EllipseMethod& method, const EllipseQuery& query) {
  Json result = {{"method", name_of(method)}, {"accommodation_D", number_or_null(view.accommodation_D)}};
  if (view.eye.status() != LensStatus::ok) {
    write_failure(result, name_of(view.eye.status()));
    result["chief_ray"] = nullptr;
    if (method == EllipseMethod(ConoidMethod::conoid))
      result["footprint"] = result["wavefront_curvature_D"] = result["focal_lines"] = nullptr;
    return result;
  }
  result["chief_ray"] = {{"origin_m", json_of(view.eye.chief_ray().origin)},
                         {"direction", json_of(view.eye.chief_ray().direction)}};
  if (const auto* ray_model = std::get_if<RayModel>(&method)) {
    write_rays(result, view, query, *ray_model);
    return result;
  }
  switch (std::get<ConoidMethod>(method)) {
    case ConoidMethod::conoid:
      write_conoid(result, view, query.eye);
      break;
    case ConoidMethod::conoid_published:
      write_published(result, view, query);
      break;
    case ConoidMethod::previous:
      write_previous(result, view, query);
      break;
  }
  return result;
}

}  // namespace

Json blur_ellipses(const EllipseQuery& query) {
  Json results = Json::array();
  for (std::size_t t = 0; t < query.targets.size(); ++t) {
    const View view = view_of(query.targets[t], query);
    for (const EllipseMethod& method : query.methods) {
      results.push_back(result_of(view, method, query));
      results.back()["target"] = t;
    }
  }
  Json document = {{"format", "sturm.ellipse_result/1"}, {"results", std::move(results)}};
  if (!query.notes.empty()) document["notes"] = query.notes;
  return document;
}

}  // namespace sturm
