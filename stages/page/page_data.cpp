#include "stages/page/page_data.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/files/build_info.h"
#include "io/json/values.h"
#include "pathtrace/scene/scene_import.h"
#include "stages/page/undrawn.h"
#include "stages/page/viewer_scene.h"
#include "stages/page/worn_numbers.h"

namespace sturm {

PageData page_data(const RenderSpec& spec, const std::string& file) {
  Json camera = camera_numbers(spec.camera, file);
  const SceneDescription scene = build_scene(spec.scene);
  const Scene built(scene);
  std::vector<std::string> notes = spec.notes;
  notes.insert(notes.end(), scene.notes.begin(), scene.notes.end());
  PageData page;
  page.view = {{"format", "sturm.viewer_view/1"},
               {"title", std::filesystem::path(file).stem().string()},
               {"view", *spec.resolved},
               {"camera", std::move(camera)},
               {"right", right_numbers(spec.eye, *spec.resolved, file)},
               {"left", left_numbers(spec.left, spec.eye, *spec.resolved, file)},
               {"interpupillary_distance_m", number_or_null(spec.camera.interpupillary_distance_m)},
               {"ray_model", spec.ray_model ? Json(name_of(*spec.ray_model)) : Json(nullptr)},
               {"not_drawn", undrawn(scene, spec)},
               {"notes", std::move(notes)},
               {"version", build_info().version}};
  page.scene = viewer_scene(scene, built);
  return page;
}

}  // namespace sturm
