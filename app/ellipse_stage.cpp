#include "app/ellipse_stage.h"

#include <cmath>

#include "app/json_values.h"
#include "app/ray_bundle.h"
#include "conoid/footprint.h"
#include "lensmodel/gaze.h"

namespace sturm {

namespace {

constexpr std::string_view ray_prefix = "rays:";

/// One target as the turned eye sees it.
struct View {
  double distance_m, vergence_D, accommodation_D;
  Eigen::Vector3d direction, pupil_center;
  Eigen::Matrix3d turn;   // takes primary axes to the turned pupil frame; Listing
};

View view_of(const Target& target, const Eye& eye) {
  View v;
  v.distance_m = target.distance_m;
  v.vergence_D = std::isinf(target.distance_m) ? 0.0 : 1.0 / target.distance_m;
  v.accommodation_D = eye.accommodation_for(v.vergence_D);
  v.direction = gaze_direction(target.azimuth, target.elevation);
  v.pupil_center = turned_pupil_center(v.direction, eye.rotation_center_m);
  v.turn = smallest_rotation({0.0, 0.0, -1.0}, v.direction);
  return v;
}

/// Quantities at the target: in metres only where it is at a finite distance.
struct AtTarget {
  const View& view;

  bool finite() const { return !std::isinf(view.distance_m); }
  Json metres(Json (*write)(const Eigen::Matrix2d&), const Eigen::Matrix2d& angular, int power) const {
    if (!finite()) return nullptr;
    return write(std::pow(view.distance_m, power) * angular);
  }
  Json metres(const Eigen::Vector2d& angular) const { return finite() ? json_of(Eigen::Vector2d(view.distance_m * angular)) : Json(nullptr); }
  Json semi_axes(const Ellipse& angular) const { return finite() ? semi_axes_json(angular, view.distance_m) : Json(nullptr); }
};

void write_ellipse(Json& result, const AtTarget& at, const Ellipse& ellipse, const Eigen::Matrix2d& covariance, const Eigen::Vector2d& centroid) {
  result["semi_axes_m"] = at.semi_axes(ellipse);
  result["semi_axes_rad"] = semi_axes_json(ellipse);
  result["orientation_deg"] = number_or_null(ellipse.orientation_deg);
  result["covariance_m2"] = at.metres(symmetric_json, covariance, 2);
  result["covariance_rad2"] = symmetric_json(covariance);
  result["centroid_m"] = at.metres(centroid);
  result["centroid_rad"] = json_of(centroid);
}

void write_conoid(Json& result, const View& view, const Eye& eye) {
  const AtTarget at{view};
  const Footprint f = naked_eye_footprint(eye, view.distance_m, view.accommodation_D);
  result["status"] = "ok";
  result["footprint"] = rows_json(at.finite() ? f.transverse() : f.angular);
  write_ellipse(result, at, Ellipse::image_of_disc(f.angular, eye.pupil_radius_m), covariance_of_disc_image(f.angular, eye.pupil_radius_m),
                Eigen::Vector2d::Zero());
  result["wavefront_curvature_D"] = f.wavefront_curvature ? symmetric_json(*f.wavefront_curvature) : Json(nullptr);
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

/// Where every given ray leaves the eye, in the wearer frame of primary gaze.
Json exit_rays(const View& view, const EyeRays<double>& rays, const std::vector<Eigen::Vector2d>& pupil_points) {
  Json list = Json::array();
  for (const Eigen::Vector2d& p : pupil_points) {
    const auto ray = rays.through(p.x(), p.y());
    if (ray.status == LaunchStatus::dropped) {
      list.push_back(nullptr);
      continue;
    }
    const Eigen::Vector3d point = view.pupil_center + view.turn * Eigen::Vector3d(ray.px, ray.py, 0.0);
    const Eigen::Vector3d direction = (view.turn * Eigen::Vector3d(ray.sx, ray.sy, -1.0)).normalized();
    list.push_back({{"exit_point_m", json_of(point)}, {"exit_direction", json_of(direction)}});
  }
  return list;
}

void write_rays(Json& result, const View& view, const EllipseQuery& query, RayModel model) {
  const AtTarget at{view};
  const auto rays = eye_rays_for(model, query.eye, view.accommodation_D);
  const MeasuredBundle bundle = rays ? measure_bundle(*rays, view.vergence_D, query.rays, query.seed) : MeasuredBundle{};
  result["rays"] = {{"launched", bundle.counters.launched}, {"lost_rim", 0}, {"lost_tir", 0}, {"undefined", bundle.counters.dropped},
                    {"negative_focus", bundle.counters.negative_focus}};
  if (rays && !query.rays.pupil_points_m.empty()) result["exit_rays"] = exit_rays(view, *rays, query.rays.pupil_points_m);
  if (!bundle.angular) {
    result["status"] = rays && bundle.counters.dropped == 0 ? "ok" : "undefined";
    for (const char* key : {"semi_axes_m", "semi_axes_rad", "orientation_deg", "covariance_m2", "covariance_rad2", "centroid_m", "centroid_rad", "standard_error"})
      result[key] = nullptr;
    return;
  }
  result["status"] = "ok";
  write_ellipse(result, at, bundle.angular->ellipse, bundle.angular->covariance, bundle.angular->centroid);
  write_standard_errors(result, at, *bundle.angular);
}

}  // namespace

Json blur_ellipses(const EllipseQuery& query) {
  Json results = Json::array();
  for (std::size_t t = 0; t < query.targets.size(); ++t) {
    const View view = view_of(query.targets[t], query.eye);
    for (const std::string& method : query.methods) {
      Json result = {{"target", t}, {"method", method}, {"accommodation_D", view.accommodation_D}};
      result["chief_ray"] = {{"origin_m", json_of(view.pupil_center)}, {"direction", json_of(view.direction)}};
      if (method.starts_with(ray_prefix)) {
        write_rays(result, view, query, *ray_model_named(std::string_view(method).substr(ray_prefix.size())));
      } else {
        write_conoid(result, view, query.eye);
      }
      results.push_back(std::move(result));
    }
  }
  Json document = {{"format", "sturm.ellipse_result/1"}, {"results", std::move(results)}};
  if (!query.notes.empty()) document["notes"] = query.notes;
  return document;
}

}  // namespace sturm
