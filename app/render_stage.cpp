#include "app/render_stage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/stopwatch.h"
#include "io/error.h"
#include "pathtrace/camera_hits.h"
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

/// What the left eye adds to the seed, beyond all seeds of documents, so that its noise is another.
constexpr std::uint64_t left_eye_seed = std::uint64_t{1} << 53;

CameraPose moved_sideways(const CameraPose& pose, double distance_m) {
  CameraPose moved = pose;
  const Eigen::Vector3d offset = distance_m * (pose.look_at - pose.position).cross(pose.up).normalized();
  moved.position += offset;
  moved.look_at += offset;
  return moved;
}

/// Two pictures of one size side by side.
Image beside(const Image& left, const Image& right) {
  Image both(left.width + right.width, left.height, left.channels);
  for (int y = 0; y < left.height; ++y) {
    std::copy_n(left.at(0, y), left.width * left.channels, both.at(0, y));
    std::copy_n(right.at(0, y), right.width * right.channels, both.at(left.width, y));
  }
  return both;
}

RenderSettings settings_of(const RenderSpec& spec, const ProgressFunction& progress) {
  RenderSettings settings;
  settings.samples_per_pixel = static_cast<int>(spec.samples_per_pixel);
  settings.max_bounces = spec.max_bounces;
  settings.guide_emitters = spec.guide_emitters && spec.method == RenderMethod::PathTrace;
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

RenderResult path_trace_view(const Scene& scene, const RenderSpec& spec, const WornEye& worn, double sideways_m,
                             const RenderSettings& settings) {
  const CameraPose pose = camera_pose(spec.camera);
  const RayModel model = *ray_model_named(spec.ray_model);
  const Eye& eye = worn.eye;
  ViewOptions options{
      spec.camera.projection, spec.camera.gaze, PupilSampler(spec.sampling, apodization_of(eye.stiles_crawford_per_m2, eye.pupil_radius_m)),
      worn.spectacles,        sideways_m,       [&scene](const LightRay& ray) { return distance_along(scene, ray); }};
  const bool plain = options.projection == Projection::Perspective && options.gaze == Gaze::Camera && options.pupil.is_uniform();
  if (plain && !options.spectacles) return path_trace(scene, moved_sideways(pose, sideways_m), eye, model, settings);
  return render(scene, ViewCamera(pose, eye, model, std::move(options)), settings);
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
          {"lost_rim_rays", c.camera.lost_rim},
          {"lost_tir_rays", c.camera.lost_total_reflection},
          {"lost_no_convergence_rays", c.camera.lost_no_convergence},
          {"guided_rays", c.guided_rays},
          {"guided_hits", c.guided_hits},
          {"bounce_rays", c.bounce_rays},
          {"shadow_rays", c.shadow_rays}};
}

namespace {

/// What one eye sees, with its counters and seconds added to `output`.
std::map<std::string, Image> layers_of_eye(const Scene& scene, const RenderSpec& spec, const WornEye& worn, double sideways_m,
                                           const RenderSettings& settings, RenderOutput& output, Json& counters) {
  Stopwatch watch;
  if (spec.method == RenderMethod::PathTrace) {
    RenderResult result = path_trace_view(scene, spec, worn, sideways_m, settings);
    output.seconds["path_tracing"] += watch.lap();
    counters = counters_json(result.counters);
    counters["guide"] = name_of(result.guide_use);
    return {{"", std::move(result.radiance)},
            {"variance", std::move(result.variance)},
            {"albedo", std::move(result.albedo)},
            {"normal", std::move(result.normal)},
            {"depth", std::move(result.depth)}};
  }
  PredictedImage result = predict(scene, camera_pose(spec.camera), worn.eye, spec.oversampling, settings);
  output.seconds["sharp_view"] += result.times.sharp_view_seconds;
  output.seconds["spreading"] += result.times.spreading_seconds;
  counters = prediction_counters_json(result);
  return {{"", std::move(result.prediction.radiance)}, {"coverage", std::move(result.prediction.coverage)}};
}

}  // namespace

RenderOutput render_view(const RenderSpec& spec, const ProgressFunction& progress) {
  RenderOutput output;
  Stopwatch watch;
  const SceneDescription description = build_scene(spec.scene);
  output.notes = description.notes;
  const Scene scene(description);
  output.seconds["scene"] = watch.lap();
  if (!spec.camera.interpupillary_distance_m) {
    output.image.layers = layers_of_eye(scene, spec, spec.eye, 0.0, settings_of(spec, progress), output, output.counters);
  } else {
    const double half = 0.5 * *spec.camera.interpupillary_distance_m;
    const auto half_of_progress = [&](double done) {
      return progress ? ProgressFunction([&progress, done](double fraction) { progress(done + 0.5 * fraction); }) : progress;
    };
    RenderSettings left = settings_of(spec, half_of_progress(0.0)), right = settings_of(spec, half_of_progress(0.5));
    left.seed += left_eye_seed;
    output.counters = Json::object();
    output.image.layers = layers_of_eye(scene, spec, spec.left.value_or(spec.eye), -half, left, output, output.counters["left"]);
    for (const auto& [name, image] : layers_of_eye(scene, spec, spec.eye, half, right, output, output.counters["right"])) {
      Image& layer = output.image.layers.at(name);
      layer = beside(layer, image);
    }
  }
  output.counters["triangles"] = scene.triangle_count();
  output.counters["embree_isa"] = scene.instruction_set();
  output.image.metadata["sturm"] = spec.resolved->dump();
  return output;
}

}  // namespace sturm
