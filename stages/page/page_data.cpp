#include "stages/page/page_data.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/files/build_info.h"
#include "io/files/error.h"
#include "io/json/values.h"
#include "pathtrace/scene/scene_import.h"
#include "stages/page/optics_numbers.h"
#include "stages/page/undrawn.h"
#include "stages/page/viewer_scene.h"

namespace sturm {

namespace {

Json camera_numbers(const CameraSpec& camera) {
  return {{"position_m", json_of(camera.position)},
          {"look_at_m", json_of(camera.look_at)},
          {"up", json_of(camera.up)},
          {"vfov_rad", camera.vfov},
          {"width", camera.width},
          {"height", camera.height},
          {"gaze", gaze_words.word_of(camera.gaze)}};
}

/// A worn eye whose lens `document` states, for the eye `made_for`.
Json worn_numbers(const WornEye& worn, const Json& document, const Source& where, const Eye& made_for) {
  Json lens;
  if (const auto design = read_lens_design(document.value("spectacles", Json()), where / "spectacles", made_for))
    lens = lens_numbers(*design);
  else if (worn.spectacles)
    lens = lens_numbers(*worn.spectacles);
  return {{"eye", eye_numbers(worn.eye)}, {"lens", std::move(lens)}};
}

/// The left eye wears the right one's spectacles unless it states its own.
Json left_numbers(const RenderSpec& spec, const Source& root) {
  if (!spec.left) return nullptr;
  const Json& left = (*spec.resolved)["left"];
  const bool states_none = !left.contains("spectacles") || (left["spectacles"].is_null() && spec.left->spectacles);
  if (states_none) return worn_numbers(*spec.left, *spec.resolved, root, spec.eye.eye);
  return worn_numbers(*spec.left, left, root / "left", spec.left->eye);
}

}  // namespace

PageData page_data(const RenderSpec& spec, const std::string& file) {
  if (spec.camera.projection != Projection::Perspective)
    throw InputError(file, "/camera/projection", "\"equirectangular\"", "\"perspective\" for a page");
  const SceneDescription scene = build_scene(spec.scene);
  const Scene built(scene);
  std::vector<std::string> notes = spec.notes;
  notes.insert(notes.end(), scene.notes.begin(), scene.notes.end());
  PageData page;
  page.view = {{"format", "sturm.viewer_view/1"},
               {"title", std::filesystem::path(file).stem().string()},
               {"view", *spec.resolved},
               {"camera", camera_numbers(spec.camera)},
               {"right", worn_numbers(spec.eye, *spec.resolved, {file, ""}, spec.eye.eye)},
               {"left", left_numbers(spec, {file, ""})},
               {"interpupillary_distance_m", number_or_null(spec.camera.interpupillary_distance_m)},
               {"ray_model", spec.ray_model ? Json(name_of(*spec.ray_model)) : Json(nullptr)},
               {"not_drawn", undrawn(scene, spec)},
               {"notes", std::move(notes)},
               {"version", build_info().version}};
  page.scene = viewer_scene(scene, built);
  return page;
}

}  // namespace sturm
