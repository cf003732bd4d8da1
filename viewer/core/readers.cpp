#include <emscripten/bind.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/json/json.h"
#include "io/json/json_text.h"
#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "io/specs/lens_design.h"
#include "io/specs/spectacles_spec.h"
#include "stages/page/optics_numbers.h"
#include "viewer/core/errors.h"
#include "viewer/core/from_js.h"

namespace sturm::viewer {

using emscripten::val;

namespace {

val object_of(const Json& value) {
  return val::global("JSON").call<val>("parse", json_text(value));
}

/// `name` is what messages call the text.
val eye_document(const std::string& text, const std::string& name) {
  const Json document = parse_json(text, name);
  validate(document, "eye", name);
  return object_of(eye_numbers(read_eye(document, Source{name, ""})));
}

val spectacles_document(const std::string& text, const std::string& name, const val& eye_numbers_of_page) {
  const Eye eye = read_eye(eye_numbers_of_page);
  const Json document = parse_json(text, name);
  if (document.is_null()) return val::null();
  validate(document, "spectacles", name);
  const Source root{name, ""};
  if (const auto design = read_lens_design(document, root, eye)) return object_of(lens_numbers(*design));
  return object_of(lens_numbers(*read_spectacles(document, root, eye).lens));
}

}  // namespace

EMSCRIPTEN_BINDINGS(sturm_readers) {
  emscripten::function("readEye", telling<&eye_document>());
  emscripten::function("readSpectacles", telling<&spectacles_document>());
}

}  // namespace sturm::viewer
