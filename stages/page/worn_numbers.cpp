#include "stages/page/worn_numbers.h"

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/values.h"
#include "io/specs/words.h"
#include "stages/page/optics_numbers.h"

namespace sturm {

namespace {

/// A worn eye whose lens `document` states, for the eye `made_for`.
Json worn_numbers(const WornEye& worn, const Json& document, const Source& where, const Eye& made_for) {
  Json lens;
  if (const auto design = read_lens_design(document.value("spectacles", Json()), where / "spectacles", made_for))
    lens = lens_numbers(*design);
  else if (worn.spectacles)
    lens = lens_numbers(*worn.spectacles);
  return {{"eye", eye_numbers(worn.eye)}, {"lens", std::move(lens)}};
}

}  // namespace

Json camera_numbers(const CameraSpec& camera, const std::string& file) {
  if (camera.projection != Projection::Perspective)
    throw InputError(file, "/camera/projection", "\"equirectangular\"", "\"perspective\" for a page");
  return {{"position_m", json_of(camera.position)},
          {"look_at_m", json_of(camera.look_at)},
          {"up", json_of(camera.up)},
          {"vfov_rad", camera.vfov},
          {"width", camera.width},
          {"height", camera.height},
          {"gaze", gaze_words.word_of(camera.gaze)}};
}

Json right_numbers(const WornEye& right, const Json& document, const std::string& file) {
  return worn_numbers(right, document, {file, ""}, right.eye);
}

Json left_numbers(const std::optional<WornEye>& left, const WornEye& right, const Json& document,
                  const std::string& file) {
  if (!left) return nullptr;
  const Source root{file, ""};
  const Json& own = document["left"];
  const bool states_none = !own.contains("spectacles") || (own["spectacles"].is_null() && left->spectacles);
  if (states_none) return worn_numbers(*left, document, root, right.eye);
  return worn_numbers(*left, own, root / "left", left->eye);
}

}  // namespace sturm
