#include "stages/render_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pathtrace/cameras/camera_hits.h"
#include "stages/plan/camera_pose.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

/// Nearest and farthest planar depth of the scene's bounding box in front of the eye. What is nearer than 0.1 m counts
/// as at 0.1 m: the guard band cannot grow without end, and the predictor reports what it had to clip.
std::pair<double, double> depth_range(const Scene& scene, const CameraPose& pose) {
  constexpr double nearest_considered = 0.1;
  const Eigen::Vector3d forward = (pose.look_at - pose.position).normalized();
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p(corner & 1 ? scene.upper().x() : scene.lower().x(),
                            corner & 2 ? scene.upper().y() : scene.lower().y(),
                            corner & 4 ? scene.upper().z() : scene.lower().z());
    const double depth = forward.dot(p - pose.position);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  nearest = std::max(nearest, nearest_considered);
  return {nearest, std::max(farthest, nearest)};
}

double fixed_accommodation(const Eye& eye) {
  return eye.accommodation_for(0.0);
}

}  // namespace

RenderResult path_trace(const Scene& scene, const CameraPose& pose, const Eye& eye, RayModel model,
                        const RenderSettings& settings, const CameraSkips& skips) {
  const EyeRays<float> rays(model, eye, fixed_accommodation(eye),
                            eye.stated_focus_distance_m().value_or(std::numeric_limits<double>::infinity()));
  return render(scene, EyeCamera(pose, rays, skips), settings);
}

RenderResult path_trace_view(const Scene& scene, const RenderSpec& spec, const WornEye& worn, double sideways_m,
                             const RenderSettings& settings, const ViewPlan& plan) {
  const CameraPose pose = camera_pose(spec.camera);
  const Eye& eye = worn.eye;
  if (plan.naked) return path_trace(scene, moved_sideways(pose, sideways_m), eye, plan.model, settings, plan.camera);
  ViewOptions options{spec.camera.projection,
                      spec.camera.gaze,
                      PupilSampler(spec.sampling, apodization_of(eye.stiles_crawford_per_m2, eye.pupil_radius_m)),
                      worn.spectacles,
                      sideways_m,
                      [&scene](const LightRay& ray) { return distance_along(scene, ray); }};
  return render(scene, GeneralCamera(pose, eye, plan.model, std::move(options)), settings);
}

PredictedImage predict(const Scene& scene, const CameraPose& pose, const Eye& eye, int oversampling,
                       const RenderSettings& settings, const PredictorSettings& spreading) {
  PredictedImage result;
  const double accommodation = fixed_accommodation(eye);
  const auto [nearest, farthest] = depth_range(scene, pose);
  const int limit = std::max(pose.width, pose.height) / 2;
  result.margin_px = std::min(required_margin_px(eye, accommodation, pixel_slope(pose), nearest, farthest), limit);
  const CameraPose wide = widened(pose, result.margin_px, oversampling);
  RenderSettings sharp = settings;
  sharp.samples_per_pixel = std::max(1, settings.samples_per_pixel / (oversampling * oversampling));
  Stopwatch watch;
  RenderResult view = path_trace(scene, wide, eye, RayModel::pinhole, sharp);
  result.times.sharp_view_seconds = watch.lap();
  result.sharp_counters = view.counters;
  result.source = {std::move(view.radiance), std::move(view.depth), result.margin_px * oversampling, pixel_slope(wide),
                   oversampling};
  result.prediction = predict_image(result.source, eye, accommodation, spreading);
  result.times.spreading_seconds = watch.lap();
  return result;
}

Json counters_json(const RenderCounters& c) {
  return {{"camera_rays", c.camera.launched},
          {"dropped_rays", c.camera.dropped},
          {"negative_focus_rays", c.camera.negative_focus},
          {"lost_rim_rays", c.camera.lost_rim},
          {"lost_tir_rays", c.camera.lost_total_reflection},
          {"lost_no_convergence_rays", c.camera.lost_no_convergence},
          {"guided_rays", c.guided_rays},
          {"guided_hits", c.guided_hits},
          {"bounce_rays", c.bounce_rays},
          {"shadow_rays", c.shadow_rays}};
}

}  // namespace sturm
