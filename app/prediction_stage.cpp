#include "app/prediction_stage.h"

#include <nlohmann/json.hpp>
#include <numeric>

#include "app/stopwatch.h"
#include "conoid/fragment_filter.h"
#include "conoid/multipass.h"
#include "pathtrace/fragment_view.h"

namespace sturm {

namespace {

SightField sight_field(const CameraSpec& camera, const WornEye& worn, double sideways_m) {
  const CameraPose pose = moved_sideways(camera_pose(camera), sideways_m);
  return SightField({pose.position, head_axes(pose), pose.width, pose.height, pixel_slope(pose), camera.gaze}, worn.eye, worn.spectacles);
}

/// The path tracer's colours for the conoid's rays.
PlaceShader place_shader(const Scene& scene, const RenderSettings& settings, RenderCounters& counters) {
  return [&scene, settings, &counters](const UnseenPlaces& places) {
    const auto rays_of = [&places](std::size_t k) {
      PlaceRays at{places.keys[k], {}};
      for (std::uint32_t i = places.first[k]; i < places.first[k + 1]; ++i)
        at.rays.emplace_back(places.rays[i].origin, places.rays[i].direction);
      return at;
    };
    return shade_places(scene, places.count(), rays_of, settings, counters);
  };
}

Json pass_counters_json(const PassCounters& c) {
  return {{"pupil_rays", c.rays}, {"unseen_rays", c.unseen_rays}, {"unseen_places", c.unseen_places}, {"lost_pixels", c.lost_pixels}};
}

}  // namespace

double PredictedView::total_seconds() const {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0, [](double sum, const auto& part) { return sum + part.second; });
}

PredictedView predict_view(const Scene& scene, const CameraSpec& camera, const WornEye& worn, double sideways_m,
                           const PredictionSpec& prediction, const RenderSettings& settings) {
  PredictedView result;
  Stopwatch watch;
  const SightField field = sight_field(camera, worn, sideways_m);
  result.seconds["blur_field"] = watch.lap();

  const int n = prediction.oversampling;
  RenderSettings sharp = settings;
  sharp.guide_emitters = false;
  sharp.samples_per_pixel = std::max(1, settings.samples_per_pixel / (n * n));
  RenderCounters shaded;
  const PicturePlane& plane = field.plane();
  FragmentImage view = render_fragments(
      scene, plane.width * n, plane.height * n,
      [&](double x, double y) {
        return field.chief_ray({x / n, y / n});
      },
      plane.pixel_slope / n, sharp, shaded);
  result.seconds["sharp_view"] = watch.lap();
  if (prediction.smooth) {
    view = filtered(view, plane.pixel_slope / n, plane.position);
    result.seconds["filter"] = watch.lap();
  }

  RenderCounters unseen;
  sharp.progress = nullptr;
  double shading_seconds = 0.0;
  const PlaceShader shade = place_shader(scene, sharp, unseen);
  const PlaceShader timed = [&](const UnseenPlaces& places) {
    const Stopwatch of_shading;
    auto radiance = shade(places);
    shading_seconds += of_shading.seconds();
    return radiance;
  };
  PassSettings pass_settings;
  pass_settings.passes = prediction.passes;
  pass_settings.rays_per_place = sharp.samples_per_pixel;
  PassPrediction predicted = predict_by_passes(view, n, field, scene.embree(), timed, pass_settings);
  result.counters = pass_counters_json(predicted.counters);
  result.layers[""] = std::move(predicted.radiance);
  result.layers["unseen"] = std::move(predicted.unseen);
  result.seconds["unseen_places"] = shading_seconds;
  result.seconds["passes"] = watch.lap() - shading_seconds;

  result.counters["sharp_view"] = counters_json(shaded);
  result.counters["unseen_shading"] = counters_json(unseen);
  result.counters["fragments"] = view.fragments.size();
  return result;
}

}  // namespace sturm
