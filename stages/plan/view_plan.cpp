#include "stages/plan/view_plan.h"

#include <Eigen/Geometry>
#include <cstdio>

#include "pathtrace/plan/simplest_model.h"

namespace sturm {

namespace {

std::string printed(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

bool is_metal(RayModel model) {
  return model == RayModel::metalstigmatism;
}

PlanItem model_item(const SkipSpec& skip, RayModel model, const Eye& eye, RayModel& used) {
  const SimplestModel simplest = simplest_model(model, eye);
  PlanItem item{"scalar_power", "", simplest.model != model, skip.scalar_power, simplest.claim, "", {}};
  item.finding = item.needless                  ? name_of(simplest.model) + " launches the rays of " + name_of(model)
                 : model == RayModel::pinhole   ? "pinhole rays have no power"
                 : model == RayModel::thin_lens ? "thin_lens has a scalar power"
                 : is_metal(model)              ? "metalstigmatism counts rays of its own"
                 : eye.wavefront                ? "a measured wavefront"
                                                : "cylinder " + printed("%.2f D", eye.prescription.cylinder_D);
  used = item.left_out() ? simplest.model : model;
  return item;
}

PlanItem refraction_item(const RenderSpec& spec, const WornEye& worn) {
  const CameraSpec& camera = spec.camera;
  const bool uniform = spec.sampling.kind == PupilSampling::UniformDisk && worn.eye.stiles_crawford_per_m2 == 0.0;
  const char* reason = worn.spectacles                                ? "spectacles"
                       : camera.projection != Projection::Perspective ? "the picture shows the whole sphere"
                       : camera.gaze != Gaze::Camera                  ? "the eye turns"
                       : !uniform                                     ? "the pupil is not uniform"
                                                                      : nullptr;
  return {"refraction",
          "",
          reason == nullptr,
          spec.skip.refraction,
          PlanClaim::rounding,
          reason ? reason : "naked eye, perspective, one gaze, uniform pupil",
          {}};
}

PlanItem pupil_item(const RenderSpec& spec, const Eye& eye, RayModel model, bool naked) {
  const bool empty = model == RayModel::pinhole || eye.pupil_radius_m == 0.0;
  PlanItem item{"zero_pupil", "", empty && naked, spec.skip.zero_pupil, PlanClaim::same_bits, "", {}};
  item.finding = !empty                       ? "pupil " + printed("%.3g mm", 2e3 * eye.pupil_radius_m)
                 : !naked                     ? "this view's camera does not tell"
                 : model == RayModel::pinhole ? "pinhole rays"
                                              : "pupil 0 mm";
  return item;
}

PlanItem sharp_item(const RenderSpec& spec, const Eye& eye, RayModel model, const CameraPose& pose,
                    const SceneDescription& scene, bool naked, ViewPlan& plan) {
  PlanItem item{"sharp_pixels", "", false, spec.skip.sharp_pixels, PlanClaim::same_bits, "", {}};
  const bool known = model == RayModel::thin_lens || model == RayModel::power_matrix || model == RayModel::sin2_radial;
  if (!naked || !known || eye.pupil_radius_m == 0.0) {
    item.finding = !known   ? "no bound for the blur of " + name_of(model)
                   : !naked ? "no bound for the blur of this view's camera"
                            : "no blur";
    return item;
  }
  const double accommodation_D = eye.accommodation_for(0.0);
  const SharpVergences sharp = sharp_vergences(eye, accommodation_D, spec.sharp_below_px * pixel_slope(pose));
  const std::string bound = plain_px(spec.sharp_below_px) + " px";
  if (sharp.empty()) {
    item.finding = "the blur exceeds " + bound + " at every distance";
    return item;
  }
  std::shared_ptr<const SharpCells> cells;
  if (item.switched_on) cells = sharp_cells(scene, pose, eye, accommodation_D, spec.sharp_below_px);
  const double share =
      cells ? static_cast<double>(cells->pixels()) / (static_cast<double>(pose.width) * pose.height) : 0.0;
  item.needless = cells != nullptr;
  item.finding = (item.switched_on ? "in " + printed("%.3g %% of the pixels", 100.0 * share)
                                   : std::string("pixels are not looked for where")) +
                 " the blur is at most " + bound + " (sharp " + described(sharp) + ")";
  if (!cells) return item;
  item.claim = PlanClaim::bounded;
  item.saved["pixels"] = cells->pixels();
  plan.camera.sharp = std::move(cells);
  return item;
}

}  // namespace

std::string plain_px(double pixels) {
  return printed("%.3g", pixels);
}

std::string described(const SharpVergences& sharp) {
  const std::string from =
      std::isinf(sharp.nearest) ? "at any distance" : "from " + printed("%.4g m", 1.0 / sharp.nearest);
  if (std::isinf(sharp.nearest)) return from;
  return from + (sharp.farthest > 0.0 ? " to " + printed("%.4g m", 1.0 / sharp.farthest) : std::string(" on"));
}

ViewPlan plan_view(const RenderSpec& spec, const WornEye& worn, const CameraPose& pose, const SceneDescription& scene,
                   const std::string& view, WorkPlan& items) {
  ViewPlan plan;
  const RayModel model = spec.ray_model.value();  // plan_render asks for views of the path tracer alone
  WorkPlan own{model_item(spec.skip, model, worn.eye, plan.model), refraction_item(spec, worn)};
  plan.naked = own.back().left_out();
  own.push_back(pupil_item(spec, worn.eye, model, plan.naked));
  plan.camera.zero_pupil = own.back().switched_on;
  own.push_back(sharp_item(spec, worn.eye, plan.model, pose, scene, plan.naked, plan));
  for (PlanItem& item : own) {
    item.view = view;
    items.push_back(std::move(item));
  }
  return plan;
}

}  // namespace sturm
