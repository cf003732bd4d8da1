#include <emscripten/bind.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "io/files/error.h"
#include "io/json/json.h"
#include "io/json/json_text.h"
#include "io/json/schema.h"
#include "io/specs/camera_spec.h"
#include "io/specs/eye_spec.h"
#include "io/specs/lens_design.h"
#include "io/specs/spectacles_spec.h"
#include "io/specs/worn_eye_spec.h"
#include "stages/page/optics_numbers.h"
#include "stages/page/worn_numbers.h"
#include "viewer/core/errors.h"
#include "viewer/core/from_js.h"

namespace sturm::viewer {

using emscripten::val;

namespace {

Json lens_of(const Json& document, const std::string& name, const Eye& wearer) {
  const Source root{name, ""};
  if (const auto design = read_lens_design(document, root, wearer)) return lens_numbers(*design);
  return lens_numbers(*read_spectacles(document, root, wearer).lens);
}

/// Without the scene: its files are not here.
Json view_of(const Json& document, const std::string& name) {
  const Source root{name, ""};
  const WornEye right = read_worn_eye(document, root).worn;
  std::optional<WornEye> left;
  if (document.contains("left")) left = read_worn_eye(document["left"], root / "left", right).worn;
  return {{"camera", camera_numbers(read_camera(document["camera"], root / "camera"), name)},
          {"right", right_numbers(right, document, name)},
          {"left", left_numbers(left, right, document, name)},
          {"ray_model", document["method"].value("ray_model", Json(nullptr))}};
}

Json contents_of(const Json& document, const std::string& name, const Eye& wearer) {
  const std::string format = format_of(document, name);
  if (format != "eye" && format != "spectacles" && format != "render")
    throw InputError(name, "/format", document["format"].dump(),
                     "sturm.eye/1, sturm.render/1 or sturm.spectacles/1 for this page");
  validate(document, format, name);
  Json resolved = with_defaults(document, format);
  resolved.erase("$schema");
  Json result = {{"format", format}};
  if (format == "eye") result["eye"] = eye_numbers(read_eye(document, Source{name, ""}));
  if (format == "spectacles") result["lens"] = lens_of(document, name, wearer);
  if (format == "render") result["view"] = view_of(resolved, name);
  result["document"] = std::move(resolved);
  return result;
}

val read_document(const std::string& text, const std::string& name, const val& wearer) {
  const Json contents = contents_of(parse_json(text, name), name, read_eye(wearer));
  return val::global("JSON").call<val>("parse", json_text(contents));
}

}  // namespace

EMSCRIPTEN_BINDINGS(sturm_readers) {
  emscripten::function("readDocument", telling<&read_document>());
}

}  // namespace sturm::viewer
