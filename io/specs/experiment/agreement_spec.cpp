#include "io/specs/experiment/agreement_spec.h"

#include <nlohmann/json.hpp>

#include "io/files/error.h"

namespace sturm {

namespace {

void append(std::vector<std::string>& files, const std::vector<std::string>& more) {
  files.insert(files.end(), more.begin(), more.end());
}

AgreementCase read_case(const Json& value, const Source& where) {
  AgreementCase c;
  c.id = value["id"].get<std::string>();
  c.note = value.value("note", "");
  c.scene_name = value["scene"].get<std::string>();
  c.scene = read_scene(value["scene"], where / "scene");
  append(c.input_files, c.scene.input_files);
  c.camera = read_camera(value["camera"], where / "camera");
  if (c.camera.projection != Projection::Perspective)
    (where / "camera" / "projection").fail(value["camera"]["projection"], "\"perspective\" for an experiment");
  if (c.camera.interpupillary_distance_m)
    (where / "camera" / "stereo").fail(value["camera"]["stereo"], "no stereo pair for an experiment");
  const WornEyeSpec worn = read_worn_eye(value, where);
  append(c.input_files, worn.input_files);
  c.worn = worn.worn;
  const bool foveal = c.camera.gaze == Gaze::Foveal;
  if (!foveal) require_camera_accommodation(c.worn.eye.accommodation, std::nullopt, where / "eye" / "accommodation");
  const Json& kinds = value["predictions"];
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    Json one = {{"prediction", kinds[i]}, {"oversampling", value.value("oversampling", 1)}};
    if (kinds[i] == "multipass") one["passes"] = value.value("passes", 64);
    c.predictions.push_back(read_prediction(one, where));
    if (c.predictions.back().kind == PredictionKind::Ellipses && (foveal || c.worn.spectacles))
      (where / "predictions" / i).fail(kinds[i], "\"layered\" or \"multipass\" for a turning eye or spectacles");
  }
  c.samples_per_pixel = value["samples_per_pixel"].get<std::uint64_t>();
  c.sharp_samples_per_pixel = value.value("sharp_samples_per_pixel", c.sharp_samples_per_pixel);
  c.replicates = value.value("replicates", c.replicates);
  c.max_bounces = value.value("max_bounces", c.max_bounces);
  return c;
}

}  // namespace

std::vector<AgreementCase> read_agreement(const Json& list, const Source& where) {
  std::vector<AgreementCase> cases;
  for (std::size_t i = 0; i < list.size(); ++i) cases.push_back(read_case(list[i], where / i));
  return cases;
}

}  // namespace sturm
