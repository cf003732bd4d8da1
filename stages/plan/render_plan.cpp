#include "stages/plan/render_plan.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "pathtrace/cameras/sharp_cells.h"
#include "pathtrace/plan/simplest_environment.h"
#include "pathtrace/plan/unseen_emitters.h"
#include "stages/plan/camera_pose.h"
#include "stages/plan/view_plan.h"

namespace sturm {

namespace {

/// What every look at a description relies on; a scene without it is refused when it is built.
bool well_formed(const SceneDescription& scene) {
  const auto regular = [&](const Mesh& mesh) {
    if (mesh.material < 0 || static_cast<std::size_t>(mesh.material) >= scene.materials.size()) return false;
    for (const Eigen::Vector3f& p : mesh.positions)
      if (!p.allFinite()) return false;
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t v : triangle)
        if (v >= mesh.positions.size()) return false;
    return true;
  };
  const auto placed = [&](const Instance& instance) {
    return instance.prototype >= 0 && static_cast<std::size_t>(instance.prototype) < scene.prototypes.size() &&
           instance.world_from_prototype.allFinite();
  };
  const auto finite = [](const Sphere& sphere) { return sphere.center.allFinite() && std::isfinite(sphere.radius); };
  return std::all_of(scene.meshes.begin(), scene.meshes.end(), regular) &&
         std::all_of(scene.prototypes.begin(), scene.prototypes.end(), regular) &&
         std::all_of(scene.instances.begin(), scene.instances.end(), placed) &&
         std::all_of(scene.spheres.begin(), scene.spheres.end(), finite);
}

PlanItem environment_item(SceneDescription& scene, const SkipSpec& skip) {
  PlanItem item{"environment_light", "", false, skip.environment_light, PlanClaim::same_bits, "", {}};
  const std::optional<Environment> before = scene.environment, simplest = simplest_environment(before);
  if (!before) {
    item.needless = true;
    item.finding = "no environment";
    return item;
  }
  item.needless = !simplest || !simplest->map;
  item.finding = !simplest       ? "a black environment"
                 : simplest->map ? "an environment of many colours"
                 : before->map   ? "an environment map of one colour"
                                 : "an environment of one colour";
  item.claim = item.needless && simplest ? PlanClaim::same_mean : PlanClaim::same_bits;
  scene.environment = item.left_out() ? simplest : sampled_environment(before);
  return item;
}

PlanItem emitters_item(SceneDescription& scene, const SkipSpec& skip) {
  const std::vector<int> unseen = unseen_emitters(scene);
  const bool some = !unseen.empty();
  PlanItem item{
      "unseen_emitters", "", some, skip.unseen_emitters, some ? PlanClaim::same_mean : PlanClaim::same_bits, "", {}};
  item.finding = some ? std::to_string(unseen.size()) + " emitting triangles face no surface"
                      : "every emitter may be seen by a surface";
  if (item.left_out()) {
    scene.unseen_emitters = unseen;
    item.saved["emitters"] = unseen.size();
  }
  return item;
}

/// The loop of the path tracer; the environment has been reduced before.
void plan_loop(const SceneDescription& scene, const SkipSpec& skip, RenderPlan& plan) {
  const Scene::Kind kind = kind_of(scene);
  const bool diffuse = kind != Scene::Kind::mixed, plain = kind == Scene::Kind::plain;
  plan.items.push_back({"surface_models",
                        "",
                        diffuse,
                        skip.surface_models,
                        PlanClaim::same_mean,
                        diffuse ? "diffuse materials only" : "materials that are not diffuse",
                        {}});
  plan.items.push_back({"shading_frames",
                        "",
                        plain,
                        skip.shading_frames && skip.surface_models,
                        PlanClaim::same_mean,
                        plain     ? "flat diffuse surfaces, nothing around"
                        : diffuse ? "smooth normals or an environment"
                                  : "materials that are not diffuse",
                        {}});
  if (!skip.surface_models)
    plan.least_kind = Scene::Kind::mixed;
  else if (!skip.shading_frames)
    plan.least_kind = Scene::Kind::diffuse;
}

/// Which tiles are good enough shows while they are rendered.
PlanItem tiles_item(const RenderSpec& spec) {
  const bool adaptive = spec.adaptive.has_value();
  return {"converged_tiles",
          "",
          adaptive,
          spec.skip.converged_tiles,
          PlanClaim::same_mean,
          adaptive ? "adaptive sampling: tiles end one by one" : "no adaptive sampling",
          {}};
}

PlanItem pair_item(const RenderSpec& spec) {
  const bool alike = eyes_are_alike(spec), together = *spec.camera.interpupillary_distance_m == 0.0;
  return {"same_views",
          "",
          alike && together,
          spec.skip.same_views,
          PlanClaim::noise_repeated,
          !alike      ? "the eyes differ"
          : !together ? "the eyes are apart"
                      : "both eyes are alike and in one place",
          {}};
}

/// The predictor's own threshold; which pixels lie below it shows when the sharp view is there.
void plan_prediction(const RenderSpec& spec, const CameraPose& pose, RenderPlan& plan) {
  if (spec.prediction.kind == PredictionKind::Multipass) return;  // spreads nothing
  if (spec.prediction.kind == PredictionKind::DepthPsf) return;   // tile by tile, once the sharp view is there
  const double threshold_px = PredictorSettings{}.sharp_below_px;
  if (spec.prediction.kind == PredictionKind::Layered) {
    plan.items.push_back({"sharp_spots",
                          "",
                          true,
                          spec.skip.sharp_spots,
                          PlanClaim::rounding,
                          "known for each ellipse once it is there",
                          {}});
    if (spec.skip.sharp_spots) plan.copied_below_px = threshold_px;
    return;
  }
  const Eye& eye = spec.eye.eye;
  const SharpVergences sharp = sharp_vergences(eye, eye.accommodation_for(0.0), threshold_px * pixel_slope(pose));
  PlanItem item{"sharp_spots", "", !sharp.empty(), spec.skip.sharp_spots, PlanClaim::rounding, "", {}};
  item.finding = sharp.empty() ? "no ellipse is below " + plain_px(threshold_px) + " px at any distance"
                               : "ellipses are below " + plain_px(threshold_px) + " px " + described(sharp);
  if (item.left_out()) plan.copied_below_px = threshold_px;
  plan.items.push_back(std::move(item));
}

}  // namespace

RenderPlan plan_render(const RenderSpec& spec, SceneDescription& scene) {
  if (!well_formed(scene)) {
    const Scene refused(scene);  // throws, and says what is wrong
    throw RuntimeFailure("the scene is malformed");
  }
  RenderPlan plan;
  plan.items.push_back(environment_item(scene, spec.skip));
  plan.items.push_back(emitters_item(scene, spec.skip));
  plan_loop(scene, spec.skip, plan);
  const CameraPose pose = camera_pose(spec.camera);
  if (spec.method == RenderMethod::Predict) {
    plan_prediction(spec, pose, plan);
    return plan;
  }
  plan.items.push_back(tiles_item(spec));
  if (!spec.camera.interpupillary_distance_m) {
    plan.right = plan_view(spec, spec.eye, pose, scene, "", plan.items);
    return plan;
  }
  const PlanItem pair = pair_item(spec);
  plan.one_view = pair.left_out();
  const double half = 0.5 * *spec.camera.interpupillary_distance_m;
  if (!plan.one_view)
    plan.left = plan_view(spec, spec.left.value_or(spec.eye), moved_sideways(pose, -half), scene, "left", plan.items);
  plan.right = plan_view(spec, spec.eye, moved_sideways(pose, half), scene, "right", plan.items);
  plan.items.push_back(pair);
  return plan;
}

void count_saved(WorkPlan& plan, const std::string& view, const RenderCounters& counters) {
  for (PlanItem& item : plan) {
    if (!item.left_out() || (!item.view.empty() && item.view != view)) continue;
    if (item.name == "scalar_power" || item.name == "refraction") item.saved["camera_rays"] += counters.camera.launched;
    if (item.name == "zero_pupil") item.saved["pupil_points"] += counters.camera.launched;
    if (item.name == "surface_models" || item.name == "shading_frames" || item.name == "environment_light")
      item.saved["bounces"] += counters.bounce_rays;
  }
}

void count_converged(WorkPlan& plan, const PassSummary& passes) {
  for (PlanItem& item : plan) {
    if (item.name != "converged_tiles" || !item.left_out()) continue;
    item.saved["tiles"] += passes.tiles_converged;
    item.saved["samples"] += passes.samples_of_longest - passes.samples_spent;
  }
}

void count_copied(WorkPlan& plan, const PredictionCounters& counters) {
  for (PlanItem& item : plan)
    if (item.name == "sharp_spots" && item.left_out())
      item.saved["pixels"] += static_cast<std::uint64_t>(counters.sharp_pixels);
}

void count_same_view(WorkPlan& plan, std::uint64_t camera_rays) {
  for (PlanItem& item : plan)
    if (item.name == "same_views" && item.left_out()) item.saved = {{"views", 1}, {"camera_rays", camera_rays}};
}

}  // namespace sturm
