#pragma once
#include <string>

#include "conoid/pictures/image_predictor.h"
#include "io/json/json.h"
#include "io/specs/render_spec.h"
#include "pathtrace/film/render.h"
#include "pathtrace/plan/plan_item.h"

namespace sturm {

/// How one eye's rays are launched.
struct ViewPlan {
  RayModel model = RayModel::power_matrix;
  bool naked = false;  ///< by EyeCamera instead of GeneralCamera
  CameraSkips camera;
};

/// What a render document's pictures do without.
struct RenderPlan {
  WorkPlan items;
  ViewPlan right, left;  ///< the only eye is the right one; of a prediction neither
  Scene::Kind least_kind = Scene::Kind::plain;
  bool one_view = false;         ///< the left eye's picture is the right one's
  double copied_below_px = 0.0;  ///< of a prediction
};

/// Decides, and reduces `scene` to what the pictures need of it. Throws InputError for a scene that cannot be rendered.
RenderPlan plan_render(const RenderSpec& spec, SceneDescription& scene);

// What rendering has saved is entered afterwards.

/// Of one eye's view; `view` as in PlanItem.
void count_saved(WorkPlan& plan, const std::string& view, const RenderCounters& counters);
/// Of tiles that came to their end before others.
void count_converged(WorkPlan& plan, const PassSummary& passes);
/// Of spreading a prediction.
void count_copied(WorkPlan& plan, const PredictionCounters& counters);
/// Of an eye whose picture is the other one's, of so many camera rays.
void count_same_view(WorkPlan& plan, std::uint64_t camera_rays);

/// For the manifest: name, view, left_out, reason, picture, saved.
Json plan_json(const WorkPlan& plan);

/// For people: one row for each item.
std::string plan_table(const WorkPlan& plan);

}  // namespace sturm
