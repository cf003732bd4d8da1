#include "io/specs/render_spec.h"

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/sharp_view_samples.h"
#include "io/specs/words.h"

namespace sturm {

namespace {

constexpr const char* prediction_keys[] = {"oversampling", "prediction", "passes", "smooth", "psf", "pupil_parts"};

void read_method(const Json& value, const Source& where, RenderSpec& spec) {
  const auto refuse = [&](const char* key, const char* type) {
    if (value.contains(key))
      (where / key).fail(value[key], std::string("no \"") + key + "\" for type \"" + type + "\"");
  };
  if (value["type"] == "predict") {
    spec.method = RenderMethod::Predict;
    for (const char* key :
         {"ray_model", "sampling", "rings", "guide_emitters", "stop", "adaptive", "denoise", "sharp_below_px"})
      refuse(key, "predict");
    spec.prediction = read_prediction(value, where);
  } else {
    for (const char* key : prediction_keys) refuse(key, "path_trace");
    if (!value.contains("ray_model"))
      throw InputError(where.file, where.pointer, "no \"ray_model\"", "a ray model for type \"path_trace\"");
    spec.ray_model = read_word(value["ray_model"], where / "ray_model", ray_model_words);
  }
  if (spec.method == RenderMethod::Predict) spec.samples_per_pixel = samples_of_sharp_view;
  spec.samples_per_pixel = value.value("samples_per_pixel", spec.samples_per_pixel);
  spec.max_bounces = value.value("max_bounces", spec.max_bounces);
  spec.guide_emitters = value.value("guide_emitters", spec.guide_emitters);
  spec.stop = read_stop(value, where, spec.samples_per_pixel);
  spec.adaptive = read_adaptive(value, where);
  spec.denoise = read_denoise(value);
  spec.sharp_below_px = value.value("sharp_below_px", spec.sharp_below_px);
  spec.sampler = word_or(value, "sampler", spec.sampler, where, sequence_words);
  spec.sampling = read_pupil_sampling(value, where);
}

/// Reads what one eye is and wears; notes and files go into the spec.
WornEye read_eye_of(const Json& value, const Source& where, const WornEye& otherwise, RenderSpec& spec) {
  WornEyeSpec read = read_worn_eye(value, where, otherwise);
  spec.notes.insert(spec.notes.end(), read.notes.begin(), read.notes.end());
  spec.input_files.insert(spec.input_files.end(), read.input_files.begin(), read.input_files.end());
  return std::move(read.worn);
}

void require_accommodation(const RenderSpec& spec, const Eye& eye, const Source& where) {
  const Source place = where / "accommodation";
  if (spec.camera.gaze == Gaze::Camera)
    require_camera_accommodation(eye.accommodation, spec.ray_model, place);
  else if (spec.ray_model)
    require_rays(*spec.ray_model, eye.accommodation, place);
}

/// One sharp layer and point spreads over depth know the naked eye in `camera` gaze; the others also spectacles and
/// turning eyes. All of them: perspective.
void require_predictable(const Json& document, const RenderSpec& spec, const Source& root) {
  const Json& camera = document["camera"];
  const PredictionKind kind = spec.prediction.kind;
  const std::string what = "prediction \"" + name_of(kind) + "\"";
  if (spec.camera.projection != Projection::Perspective)
    (root / "camera" / "projection").fail(camera["projection"], "\"perspective\" for type \"predict\"");
  if (kind == PredictionKind::Ellipses || kind == PredictionKind::DepthPsf) {
    const std::string other = what + " (\"layered\" and \"multipass\" know more)";
    if (kind == PredictionKind::Ellipses) require_plain_camera(camera, root / "camera", other);
    if (spec.camera.gaze != Gaze::Camera) (root / "camera" / "gaze").fail(camera["gaze"], "\"camera\" for " + other);
    if (spec.eye.spectacles) (root / "spectacles").fail(document["spectacles"], "null, the naked eye, for " + other);
    if (spec.left && spec.left->spectacles)
      (root / "left" / "spectacles").fail(document["left"]["spectacles"], "null, the naked eye, for " + other);
  }
  require_pupil(spec.prediction, spec.eye.eye, root / "eye");
  if (spec.left) require_pupil(spec.prediction, spec.left->eye, root / "left" / "eye");
  if (kind == PredictionKind::Multipass || kind == PredictionKind::DepthPsf) return;
  for (const auto* worn : {&spec.eye, spec.left ? &*spec.left : nullptr})
    if (worn && worn->eye.stiles_crawford_per_m2 != 0.0)
      throw InputError(root.file, "/eye/stiles_crawford_per_mm2", "an apodized pupil",
                       "0 for " + what + ": ellipses are filled evenly");
}

Json resolved_render(const Json& document, const Source& root, const RenderSpec& spec) {
  Json resolved = document;
  resolved.erase("$schema");
  resolved["eye"] = eye_object(document["eye"], root / "eye");
  resolved["eye"].erase("$schema");
  if (document.contains("left") && document["left"].contains("eye")) {
    resolved["left"]["eye"] = eye_object(document["left"]["eye"], root / "left" / "eye");
    resolved["left"]["eye"].erase("$schema");
  }
  resolved["method"]["samples_per_pixel"] = spec.samples_per_pixel;
  resolved = with_defaults(resolved, "render");
  Json& method = resolved["method"];
  if (method["type"] == "path_trace") {
    for (const char* key : prediction_keys) method.erase(key);
  } else {
    for (const std::string& key : keys_without_meaning(method)) method.erase(key);
    method.erase("sampling");
    method.erase("guide_emitters");
    method.erase("sharp_below_px");
  }
  return resolved;
}

}  // namespace

bool eyes_are_alike(const RenderSpec& spec) {
  const Json& document = *spec.resolved;
  if (!document.contains("left")) return true;
  const auto alike = [&](const char* key) {
    return !document["left"].contains(key) || document["left"][key] == document.value(key, Json(nullptr));
  };
  return alike("eye") && alike("spectacles");
}

RenderSpec read_render_spec(const Json& document, const std::string& file) {
  validate(document, "render", file);
  const Source root{file, ""};
  RenderSpec spec;
  spec.scene = read_scene(document["scene"], root / "scene");
  spec.camera = read_camera(document["camera"], root / "camera");
  spec.eye = read_eye_of(document, root, {}, spec);
  if (document.contains("left")) {
    if (!spec.camera.interpupillary_distance_m)
      (root / "left").fail(document["left"], "no \"left\" without \"stereo\" in the camera");
    spec.left = read_eye_of(document["left"], root / "left", spec.eye, spec);
  }
  spec.input_files.insert(spec.input_files.end(), spec.scene.input_files.begin(), spec.scene.input_files.end());
  read_method(document["method"], root / "method", spec);
  require_accommodation(spec, spec.eye.eye, root / "eye");
  if (spec.left)
    require_accommodation(spec, spec.left->eye,
                          document["left"].contains("eye") ? root / "left" / "eye" : root / "eye");
  if (spec.method == RenderMethod::Predict) require_predictable(document, spec, root);
  spec.seed = document.value("seed", spec.seed);
  spec.resolved = std::make_shared<const Json>(resolved_render(document, root, spec));
  spec.skip = read_skips((*spec.resolved)["method"]["skip"]);
  return spec;
}

}  // namespace sturm
