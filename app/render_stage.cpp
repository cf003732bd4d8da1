#include "app/render_stage.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/stopwatch.h"
#include "io/error.h"
#include "pathtrace/scene_import.h"

namespace sturm {

namespace {

/// Nearest and farthest planar depth of the scene's bounding box in front of the eye. What is nearer than 0.1 m counts as at 0.1 m:
/// the guard band cannot grow without end, and the predictor reports what it had to clip.
std::pair<double, double> depth_range(const Scene& scene, const CameraPose& pose) {
  constexpr double nearest_considered = 0.1;
  const Eigen::Vector3d forward = (pose.look_at - pose.position).normalized();
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p(corner & 1 ? scene.upper().x() : scene.lower().x(), corner & 2 ? scene.upper().y() : scene.lower().y(),
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

Json prediction_counters_json(const PredictedImage& p) {
  const PredictionCounters& c = p.prediction.counters;
  return {{"sharp_view", counters_json(p.sharp_counters)},
          {"spread_pixels", c.splatted_pixels},
          {"copied_pixels", c.sharp_pixels},
          {"hidden_pixels", c.hidden_pixels},
          {"depth_layers", c.layers},
          {"margin_px", p.margin_px},
          {"clipped_radius_px", c.clipped_radius_px}};
}

RenderSettings settings_of(const RenderSpec& spec, const ProgressFunction& progress) {
  RenderSettings settings;
  settings.samples_per_pixel = static_cast<int>(spec.samples_per_pixel);
  settings.max_bounces = spec.max_bounces;
  settings.sequence = spec.sampler;
  settings.seed = spec.seed;
  settings.progress = progress;
  return settings;
}

}  // namespace

CameraPose camera_pose(const CameraSpec& spec) {
  return {spec.position, spec.look_at, spec.up, spec.vfov, spec.width, spec.height};
}

RenderResult path_trace(const Scene& scene, const CameraPose& pose, const Eye& eye, RayModel model, const RenderSettings& settings) {
  const auto focus = eye.stated_focus_distance_m();
  if (model == RayModel::metalstigmatism && !focus)
    throw InputError("", "/eye/accommodation", "no focus distance",
                     "{\"mode\": \"fixed\", \"focus_distance_m\": …}, which the ray model metalstigmatism needs");
  const EyeRays<float> rays(model, eye, fixed_accommodation(eye), focus.value_or(std::numeric_limits<double>::infinity()));
  return render(scene, EyeCamera(pose, rays), settings);
}

PredictedImage predict(const Scene& scene, const CameraPose& pose, const Eye& eye, int oversampling, const RenderSettings& settings) {
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
  const SharpView source{std::move(view.radiance), std::move(view.depth), result.margin_px * oversampling, pixel_slope(wide), oversampling};
  result.prediction = predict_image(source, eye, accommodation);
  result.times.spreading_seconds = watch.lap();
  return result;
}

Json counters_json(const RenderCounters& c) {
  return {{"camera_rays", c.camera.launched},
          {"dropped_rays", c.camera.dropped},
          {"negative_focus_rays", c.camera.negative_focus},
          {"bounce_rays", c.bounce_rays},
          {"shadow_rays", c.shadow_rays}};
}

RenderOutput render_view(const RenderSpec& spec, const ProgressFunction& progress) {
  RenderOutput output;
  Stopwatch watch;
  const SceneDescription description = build_scene(spec.scene);
  output.notes = description.notes;
  const Scene scene(description);
  output.seconds["scene"] = watch.lap();
  const RenderSettings settings = settings_of(spec, progress);
  const CameraPose pose = camera_pose(spec.camera);
  if (spec.method == RenderMethod::PathTrace) {
    RenderResult result = path_trace(scene, pose, spec.eye, *ray_model_named(spec.ray_model), settings);
    output.seconds["path_tracing"] = watch.lap();
    output.counters = counters_json(result.counters);
    output.image.layers = {{"", std::move(result.radiance)},
                           {"variance", std::move(result.variance)},
                           {"albedo", std::move(result.albedo)},
                           {"normal", std::move(result.normal)},
                           {"depth", std::move(result.depth)}};
  } else {
    PredictedImage result = predict(scene, pose, spec.eye, spec.oversampling, settings);
    output.seconds["sharp_view"] = result.times.sharp_view_seconds;
    output.seconds["spreading"] = result.times.spreading_seconds;
    output.counters = prediction_counters_json(result);
    output.image.layers = {{"", std::move(result.prediction.radiance)}, {"coverage", std::move(result.prediction.coverage)}};
  }
  output.counters["triangles"] = scene.triangle_count();
  output.counters["embree_isa"] = scene.instruction_set();
  output.image.metadata["sturm"] = spec.resolved->dump();
  return output;
}

}  // namespace sturm
