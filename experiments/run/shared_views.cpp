#include "experiments/run/shared_views.h"

#include <nlohmann/json.hpp>

#include "experiments/run/scene_fingerprint.h"
#include "io/json/values.h"
#include "pathtrace/plan/simplest_model.h"

namespace sturm {

SharedViews::SharedViews(const ExperimentSpec& spec, const std::vector<SceneDescription>& scenes) : spec_(spec) {
  if (!spec.share_views) return;
  for (const SceneDescription& scene : scenes) fingerprints_.push_back(scene_fingerprint(scene));
  for (std::size_t i = 0; i < spec.pictures.size(); ++i)
    if (spec.pictures[i].measures == PictureMeasures::Metrics)
      for (const RayModel model : spec.pictures[i].ray_models) ++views_[key(i, model)].requests;
}

/// All that the bits of a picture depend on within one experiment.
std::string SharedViews::key(std::size_t index, RayModel model) const {
  const PictureExperiment& picture = spec_.pictures[index];
  const CameraSpec& camera = picture.camera;
  const Eye& eye = picture.worn.eye;
  const SimplestModel simplest = simplest_model(model, eye);
  const RayModel used = simplest.claim == PlanClaim::same_bits ? simplest.model : model;
  const PowerMatrix& power = eye.correction;
  return Json{fingerprints_[index],
              json_of(camera.position),
              json_of(camera.look_at),
              json_of(camera.up),
              camera.vfov,
              camera.width,
              camera.height,
              {power.xx(), power.xy(), power.yy(), eye.pupil_radius_m, eye.accommodation_for(0.0)},
              number_or_null(eye.stated_focus_distance_m()),
              name_of(used),
              picture.samples_per_pixel,
              picture.max_bounces,
              picture.guide_emitters,
              picture.replicates}
      .dump();
}

std::shared_ptr<const SharedViews::View> SharedViews::get(std::size_t index, RayModel model,
                                                          const std::function<View()>& make) {
  if (!spec_.share_views) return std::make_shared<const View>(make());
  Shared& shared = views_.at(key(index, model));
  if (!shared.view) shared.view = std::make_shared<const View>(make());
  std::shared_ptr<const View> view = shared.view;
  if (--shared.requests == 0) shared.view.reset();
  return view;
}

}  // namespace sturm
