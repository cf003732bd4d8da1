#include <algorithm>
#include <nlohmann/json.hpp>

#include "pathtrace/scene/scene_import.h"
#include "stages/dark_picture.h"
#include "stages/path_traced_layers.h"
#include "stages/plan/camera_pose.h"
#include "stages/prediction_stage.h"
#include "stages/render_stage.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

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

/// Two pictures of one size side by side.
Image beside(const Image& left, const Image& right) {
  Image both(left.width + right.width, left.height, left.channels);
  for (int y = 0; y < left.height; ++y) {
    std::copy_n(left.at(0, y), left.width * left.channels, both.at(0, y));
    std::copy_n(right.at(0, y), right.width * right.channels, both.at(left.width, y));
  }
  return both;
}

/// One eye of a render document.
struct EyeTask {
  const WornEye& worn;
  double sideways_m;  ///< where it is to the right of the camera's position
  std::string view;   ///< as in PlanItem
  RenderSettings settings;
  Preview preview;
};

/// Renders the eyes of a document and gathers layers, counters and seconds.
class DocumentRenderer {
 public:
  DocumentRenderer(const RenderSpec& spec, const Scene& scene, RenderPlan& plan, RenderOutput& output)
      : spec_(spec), scene_(scene), plan_(plan), output_(output) {}

  void render_one(const ProgressFunction& progress, const Preview& preview) {
    EyePicture picture = render_eye({spec_.eye, 0.0, "", settings(progress), preview});
    output_.image.layers = std::move(picture.layers);
    output_.counters = std::move(picture.counters);
  }

  /// A stereo pair, left beside right. Eyes that see the same are rendered once.
  void render_pair(const ProgressFunction& progress, const Preview& preview) {
    const double half = 0.5 * *spec_.camera.interpupillary_distance_m;
    const double left_share = plan_.one_view ? 0.0 : 0.5;
    std::optional<EyePicture> left;
    if (!plan_.one_view) {
      EyeTask task{spec_.left.value_or(spec_.eye), -half, "left", settings(part_of(progress, 0.0, left_share)),
                   preview};
      task.settings.seed += left_eye_seed;
      const Image black(spec_.camera.width, spec_.camera.height, 3);
      if (preview.show) task.preview.show = [&](const Image& picture) { preview.show(beside(picture, black)); };
      left = render_eye(task);
    }
    EyeTask task{spec_.eye, half, "right", settings(part_of(progress, left_share, 1.0 - left_share)), preview};
    if (preview.show)
      task.preview.show = [&](const Image& picture) {
        preview.show(beside(left ? left->layers.at("") : picture, picture));
      };
    const EyePicture right = render_eye(task);
    for (const auto& [name, image] : right.layers)
      output_.image.layers[name] = beside(left ? left->layers.at(name) : image, image);
    output_.counters = {{"left", left ? left->counters : counters_json({})}, {"right", right.counters}};
    if (!left) count_same_view(plan_.items, right.counters.at("camera_rays").get<std::uint64_t>());
  }

 private:
  struct EyePicture {
    std::map<std::string, Image> layers;
    Json counters;
  };

  static ProgressFunction part_of(const ProgressFunction& progress, double done, double share) {
    if (!progress) return progress;
    return [&progress, done, share](double fraction) { progress(done + share * fraction); };
  }

  RenderSettings settings(const ProgressFunction& progress) const {
    RenderSettings settings;
    settings.samples_per_pixel = static_cast<int>(spec_.samples_per_pixel);
    settings.max_bounces = spec_.max_bounces;
    settings.guide_emitters = spec_.guide_emitters && spec_.method == RenderMethod::PathTrace;
    settings.sequence = spec_.sampler;
    settings.least_kind = plan_.least_kind;
    settings.seed = spec_.seed;
    settings.progress = progress;
    settings.relative_error = spec_.stop.relative_error;
    settings.adaptive = spec_.adaptive;
    settings.end_converged_tiles = spec_.skip.converged_tiles;
    settings.guide_layers = spec_.denoise.has_value();
    return settings;
  }

  EyePicture render_eye(const EyeTask& task) {
    return spec_.method == RenderMethod::PathTrace ? path_traced(task) : predicted(task);
  }

  EyePicture path_traced(const EyeTask& task) {
    Stopwatch watch;
    RenderResult result = path_trace_watched(task);
    output_.seconds["path_tracing"] += watch.lap();
    EyePicture picture{{}, counters_json(result.counters)};
    picture.counters["guide"] = name_of(result.guide_use);
    if (may_stop_early(spec_)) picture.counters["sampling"] = sampling_json(result.passes, spec_);
    count_saved(plan_.items, task.view, result.counters);
    count_converged(plan_.items, result.passes);
    if (result.passes.interrupted) output_.notes.push_back(interruption_note(result.passes, spec_));
    picture.layers = path_traced_layers(std::move(result), spec_);
    if (spec_.denoise) output_.seconds["denoising"] += watch.lap();
    return picture;
  }

  /// With a budget of time and previews, which need a clock.
  RenderResult path_trace_watched(const EyeTask& task) const {
    const ViewPlan& view = task.view == "left" ? plan_.left : plan_.right;
    PassWatch watch(spec_.stop.seconds, task.preview);
    RenderSettings watched = task.settings;
    if (watch.needed()) watched.after_pass = [&watch](const PassReport& report) { return watch(report); };
    return path_trace_view(scene_, spec_, task.worn, task.sideways_m, watched, view);
  }

  EyePicture predicted(const EyeTask& task) {
    PredictorSettings spreading;
    spreading.sharp_below_px = plan_.copied_below_px;
    if (spec_.prediction.kind != PredictionKind::Ellipses) {
      PredictedView view =
          predict_view(scene_, spec_.camera, task.worn, task.sideways_m, spec_.prediction, task.settings, spreading);
      for (const auto& [part, seconds] : view.seconds) output_.seconds[part] += seconds;
      count_saved(plan_.items, task.view, view.shaded);
      count_copied(plan_.items, view.spread);
      return {std::move(view.layers), std::move(view.counters)};
    }
    PredictedImage result = predict(scene_, camera_pose(spec_.camera), task.worn.eye, spec_.prediction.oversampling,
                                    task.settings, spreading);
    output_.seconds["sharp_view"] += result.times.sharp_view_seconds;
    output_.seconds["spreading"] += result.times.spreading_seconds;
    count_saved(plan_.items, task.view, result.sharp_counters);
    count_copied(plan_.items, result.prediction.counters);
    Json counters = prediction_counters_json(result);
    return {{{"", std::move(result.prediction.radiance)}, {"coverage", std::move(result.prediction.coverage)}},
            std::move(counters)};
  }

  const RenderSpec& spec_;
  const Scene& scene_;
  RenderPlan& plan_;
  RenderOutput& output_;
};

/// What `depth_psf` does with each layer of each tile of a document's pictures. Where surfaces are is enough for that,
/// so nothing is lit.
std::string explained_tiles(const RenderSpec& spec, const Scene& scene) {
  RenderSettings outlines;
  outlines.samples_per_pixel = 16;
  outlines.max_bounces = 0;
  PredictionSpec prediction = spec.prediction;
  prediction.smooth = false;
  const auto explained = [&](const WornEye& worn, double sideways_m) {
    return predict_view(scene, spec.camera, worn, sideways_m, prediction, outlines).explanation;
  };
  if (!spec.camera.interpupillary_distance_m) return explained(spec.eye, 0.0);
  const double half = 0.5 * *spec.camera.interpupillary_distance_m;
  return "left eye: " + explained(spec.left.value_or(spec.eye), -half) + "\nright eye: " + explained(spec.eye, half);
}

}  // namespace

std::string explain_view(const RenderSpec& spec) {
  SceneDescription description = build_scene(spec.scene);
  const std::string table = plan_table(plan_render(spec, description).items);
  const bool by_tiles = spec.method == RenderMethod::Predict && spec.prediction.kind == PredictionKind::DepthPsf;
  return by_tiles ? table + "\n" + explained_tiles(spec, Scene(description)) : table;
}

RenderOutput render_view(const RenderSpec& spec, const ProgressFunction& progress, const Preview& preview) {
  RenderOutput output;
  Stopwatch watch;
  SceneDescription description = build_scene(spec.scene);
  output.notes = spec.notes;
  output.notes.insert(output.notes.end(), description.notes.begin(), description.notes.end());
  output.seconds["scene"] = watch.lap();
  RenderPlan plan = plan_render(spec, description);
  output.seconds["plan"] = watch.lap();
  const Scene scene(description);
  output.seconds["scene"] += watch.lap();
  DocumentRenderer renderer(spec, scene, plan, output);
  if (spec.camera.interpupillary_distance_m)
    renderer.render_pair(progress, preview);
  else
    renderer.render_one(progress, preview);
  if (spec.denoise) output.notes.push_back(denoised_note);
  if (const auto reason = reason_of_darkness(scene, output.image.layers.at(""))) {
    output.warning = *reason;
    output.notes.push_back(*reason);
  }
  output.counters["triangles"] = scene.triangle_count();
  output.counters["embree_isa"] = scene.instruction_set();
  output.counters["plan"] = plan_json(plan.items);
  output.image.metadata["sturm"] = spec.resolved->dump();
  return output;
}

}  // namespace sturm
