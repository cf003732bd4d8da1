#pragma once
#include <string>

#include "pathtrace/cameras/sharp_cells.h"
#include "stages/plan/render_plan.h"

namespace sturm {

/// Decides how the rays of one eye at `pose` are launched, and enters the items into `items`; `view` as in PlanItem.
ViewPlan plan_view(const RenderSpec& spec, const WornEye& worn, const CameraPose& pose, const SceneDescription& scene,
                   const std::string& view, WorkPlan& items);

/// A number of pixels for people.
std::string plain_px(double pixels);

/// "from 2.9 m to 3.1 m", "from 40 m on".
std::string described(const SharpVergences& sharp);

}  // namespace sturm
