#include "stages/prediction_stage.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "conoid/pictures/fragment_filter.h"
#include "conoid/pictures/layered_predictor.h"
#include "conoid/pictures/multipass.h"
#include "pathtrace/film/fragment_view.h"
#include "pathtrace/scene/hit_packet.h"
#include "stages/plan/camera_pose.h"
#include "stages/plan/render_plan.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

constexpr int passes_to_find_unseen =
    16;  // of a sharp pixel: what less than a sixteenth of the pupil sees hardly matters

/// The path tracer's scene as the conoid asks for it.
FirstHits first_hits_of(const Scene& scene) {
  return [&scene](std::span<const SeenRay> rays, float from_m, std::span<FirstHit> hits) {
    for (std::size_t first = 0; first < rays.size(); first += HitPacket::size) {
      HitPacket packet;
      const int count = static_cast<int>(std::min<std::size_t>(HitPacket::size, rays.size() - first));
      for (int lane = 0; lane < count; ++lane) {
        const SeenRay& ray = rays[first + static_cast<std::size_t>(lane)];
        packet.set(lane, ray.origin, ray.direction);
        if (from_m > 0.0f) packet.start_at(lane, from_m / ray.direction.norm());
      }
      packet.first_hits(scene.embree());
      for (int lane = 0; lane < count; ++lane) {
        const std::size_t i = first + static_cast<std::size_t>(lane);
        hits[i] = packet.hit(lane)
                      ? FirstHit{packet.distance(lane), scene.shines(packet.record(lane), rays[i].direction)}
                      : FirstHit{};
      }
    }
  };
}

/// One picture on its way: the sharp view, and what the predictors do with it.
class PredictionRun {
 public:
  PredictionRun(const Scene& scene, const SightField& field, const PredictionSpec& prediction,
                const RenderSettings& settings, PredictedView& result)
      : scene_(scene),
        field_(field),
        prediction_(prediction),
        settings_(settings),
        result_(result),
        first_hits_(first_hits_of(scene)) {
    const int n = prediction.oversampling;
    settings_.guide_emitters = false;
    settings_.samples_per_pixel = std::max(1, settings.samples_per_pixel / (n * n));
    passes_.rays_per_place = settings_.samples_per_pixel;
  }

  void render_sharp_view() {
    const PicturePlane& plane = field_.plane();
    const int n = prediction_.oversampling;
    const double sharp_slope = plane.pixel_slope / n;
    RenderCounters& counters = result_.shaded;
    view_ = render_fragments(
        scene_, plane.width * n, plane.height * n,
        [&](double x, double y) {
          return field_.chief_ray({x / n, y / n});
        },
        sharp_slope, settings_, counters);
    result_.seconds["sharp_view"] = watch_.lap();
    if (prediction_.smooth) {
      view_ = filtered(view_, sharp_slope, plane.position);
      result_.seconds["filter"] = watch_.lap();
    }
    result_.counters["sharp_view"] = counters_json(counters);
    result_.counters["fragments"] = view_.fragments.size();
  }

  void blend_passes() {
    passes_.passes = prediction_.passes;
    PassPrediction predicted =
        predict_by_passes(view_, prediction_.oversampling, field_, first_hits_, shader(), passes_);
    result_.seconds["passes"] = watch_.lap() - shading_seconds_;
    report(predicted.counters);
    result_.layers[""] = std::move(predicted.radiance);
    result_.layers["unseen"] = std::move(predicted.unseen);
  }

  void spread_layers(const PredictorSettings& spreading) {
    Prediction predicted = predict_by_layers(view_, prediction_.oversampling, field_, find_unseen(), spreading);
    result_.seconds["spreading"] = watch_.lap();
    result_.spread = predicted.counters;
    result_.counters["depth_layers"] = predicted.counters.layers;
    result_.counters["spread_pixels"] = predicted.counters.splatted_pixels;
    result_.counters["copied_pixels"] = predicted.counters.sharp_pixels;
    result_.layers[""] = std::move(predicted.radiance);
    result_.layers["coverage"] = std::move(predicted.coverage);
  }

  void blur_by_depth() {
    const int n = prediction_.oversampling;
    const PicturePlane& plane = field_.plane();
    SurfacesPicture surfaces = surfaces_picture(surface_pieces(view_, n, field_, find_unseen()), plane.width * n,
                                                plane.height * n, sheet_thickness_D(n, field_));
    result_.seconds["surfaces"] = watch_.lap();
    SeenPicture seen = see_through_point_spreads(surfaces, field_.eye(), plane.pixel_slope, prediction_);
    result_.layers[""] = std::move(seen.radiance);
    for (const auto& [part, seconds] : seen.seconds) result_.seconds[part] = seconds;
    result_.counters.update(counters_of(seen));
    result_.counters["margin_px"] = surfaces.margin_px;
    result_.explanation = explanation_of(seen);
    result_.surfaces = std::move(surfaces);
  }

 private:
  /// What the sharp view does not show, along first-order rays through the pupil.
  std::vector<UnseenPiece> find_unseen() {
    const int n = prediction_.oversampling;
    passes_.passes = passes_to_find_unseen * n * n;
    PassCounters found;
    std::vector<UnseenPiece> unseen = unseen_pieces(view_, n, field_, first_hits_, shader(), passes_, found);
    result_.seconds["passes"] = watch_.lap() - shading_seconds_;
    report(found);
    return unseen;
  }

  /// The path tracer's colours for the conoid's rays.
  PlaceShader shader() {
    return [this](const UnseenPlaces& places) {
      const Stopwatch of_shading;
      RenderSettings quiet = settings_;
      quiet.progress = nullptr;
      const auto rays_of = [&places](std::size_t k) {
        PlaceRays at{places.keys[k], {}};
        for (std::uint32_t i = places.first[k]; i < places.first[k + 1]; ++i)
          at.rays.emplace_back(places.rays[i].origin, places.rays[i].direction);
        return at;
      };
      auto radiance = shade_places(scene_, places.count(), rays_of, quiet, unseen_);
      shading_seconds_ = of_shading.seconds();
      return radiance;
    };
  }

  void report(const PassCounters& c) {
    result_.seconds["unseen_places"] = shading_seconds_;
    result_.counters["pupil_rays"] = c.rays;
    result_.counters["unseen_rays"] = c.unseen_rays;
    result_.counters["unseen_places"] = c.unseen_places;
    result_.counters["lamp_pixels"] = c.lamp_pixels;
    result_.counters["bright_lamp_pixels"] = c.bright_lamp_pixels;
    result_.counters["lost_pixels"] = c.lost_pixels;
    result_.counters["unseen_shading"] = counters_json(unseen_);
  }

  const Scene& scene_;
  const SightField& field_;
  const PredictionSpec& prediction_;
  RenderSettings settings_;
  PredictedView& result_;
  FirstHits first_hits_;
  PassSettings passes_;
  FragmentImage view_;
  RenderCounters unseen_;
  double shading_seconds_ = 0.0;
  Stopwatch watch_;
};

}  // namespace

SightField sight_field(const CameraSpec& camera, const WornEye& worn, double sideways_m) {
  const CameraPose pose = moved_sideways(camera_pose(camera), sideways_m);
  return SightField({pose.position, head_axes(pose), pose.width, pose.height, pixel_slope(pose), camera.gaze}, worn.eye,
                    worn.spectacles);
}

SeenPicture see_through_point_spreads(SurfacesPicture& surfaces, const Eye& eye, double pixel_slope,
                                      const PredictionSpec& prediction) {
  const int n = prediction.oversampling;
  SeenPicture seen = see_surfaces(surfaces.picture, {.eye = eye,
                                                     .accommodation_D = eye.accommodation_for(0.0),
                                                     .pixel_slope = pixel_slope / n,
                                                     .psf = prediction.psf,
                                                     .parts = prediction.pupil_parts});
  seen.radiance = without_margin(seen.radiance, surfaces.margin_px, n);
  return seen;
}

PredictedView predict_view(const Scene& scene, const CameraSpec& camera, const WornEye& worn, double sideways_m,
                           const PredictionSpec& prediction, const RenderSettings& settings,
                           const PredictorSettings& spreading) {
  PredictedView result;
  Stopwatch watch;
  const SightField field = sight_field(camera, worn, sideways_m);
  result.seconds["blur_field"] = watch.lap();
  PredictionRun run(scene, field, prediction, settings, result);
  run.render_sharp_view();
  if (prediction.kind == PredictionKind::Layered)
    run.spread_layers(spreading);
  else if (prediction.kind == PredictionKind::DepthPsf)
    run.blur_by_depth();
  else
    run.blend_passes();
  return result;
}

}  // namespace sturm
