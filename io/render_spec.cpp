#include "io/render_spec.h"

#include <nlohmann/json.hpp>

#include "io/error.h"
#include "io/schema.h"

namespace sturm {

namespace {

void read_method(const Json& value, const Source& where, RenderSpec& spec) {
  const auto refuse = [&](const char* key, const char* type) {
    if (value.contains(key)) (where / key).fail(value[key], std::string("no \"") + key + "\" for type \"" + type + "\"");
  };
  if (value["type"] == "predict") {
    spec.method = RenderMethod::Predict;
    refuse("ray_model", "predict");
    spec.oversampling = value.value("oversampling", spec.oversampling);
  } else {
    refuse("oversampling", "path_trace");
    if (!value.contains("ray_model"))
      throw InputError(where.file, where.pointer, "no \"ray_model\"", "a ray model for type \"path_trace\"");
    spec.ray_model = value["ray_model"].get<std::string>();
  }
  spec.samples_per_pixel = value.value("samples_per_pixel", spec.samples_per_pixel);
  spec.max_bounces = value.value("max_bounces", spec.max_bounces);
  spec.sampler = read_sequence(value.value("sampler", "sobol"));
}

Json resolved_render(const Json& document, const Source& root) {
  Json resolved = document;
  resolved.erase("$schema");
  resolved["eye"] = eye_object(document["eye"], root / "eye");
  resolved["eye"].erase("$schema");
  resolved = with_defaults(resolved, "render");
  if (resolved["method"]["type"] == "path_trace") resolved["method"].erase("oversampling");
  return resolved;
}

}  // namespace

RenderSpec read_render_spec(const Json& document, const std::string& file) {
  validate(document, "render", file);
  const Source root{file, ""};
  RenderSpec spec;
  spec.scene = read_scene(document["scene"], root / "scene");
  spec.camera = read_camera(document["camera"], root / "camera");
  EyeSpec eye = read_eye_spec(document["eye"], root / "eye");
  spec.eye = eye.eye;
  spec.notes = std::move(eye.notes);
  spec.input_files = std::move(eye.input_files);
  spec.input_files.insert(spec.input_files.end(), spec.scene.input_files.begin(), spec.scene.input_files.end());
  read_method(document["method"], root / "method", spec);
  require_camera_accommodation(spec.eye.accommodation, spec.ray_model, root / "eye" / "accommodation");
  spec.seed = document.value("seed", spec.seed);
  spec.resolved = std::make_shared<const Json>(resolved_render(document, root));
  return spec;
}

}  // namespace sturm
