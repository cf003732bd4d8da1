#include "io/specs/experiment/sampling_study_spec.h"

#include <nlohmann/json.hpp>
#include <set>

#include "io/specs/words.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

SamplingConfiguration read_configuration(const Json& value, double pupil_diameter_m, const Accommodation& accommodation,
                                         const Source& where) {
  SamplingConfiguration configuration;
  configuration.id = value["id"].get<std::string>();
  configuration.note = value.value("note", "");
  configuration.ray_model = read_word(value["ray_model"], where / "ray_model", ray_model_words);
  configuration.eye = make_eye(read_prescription(value["prescription"], where / "prescription"), pupil_diameter_m,
                               accommodation, where);
  require_camera_accommodation(accommodation, configuration.ray_model, where / "ray_model");
  return configuration;
}

/// A sampling of the list; `rings` of the study belong to the one of that name.
PupilSamplingSpec read_sampling(const Json& name, const Json& study, const Source& where) {
  Json rays = {{"sampling", name}};
  if (name == "rings" && study.contains("rings")) rays["rings"] = study["rings"];
  return read_pupil_sampling(rays, where);
}

}  // namespace

SamplingStudySpec read_sampling_study(const Json& value, const Source& where) {
  SamplingStudySpec study;
  study.scene_name = value["scene"].get<std::string>();
  study.scene = read_scene(value["scene"], where / "scene");
  study.camera = read_camera(value["camera"], where / "camera");
  require_plain_camera(value["camera"], where / "camera", "a sampling study");
  const double pupil_diameter_m = metres_per_millimetre * value["pupil_diameter_mm"].get<double>();
  const Accommodation accommodation = value.contains("accommodation")
                                          ? read_accommodation(value["accommodation"], where / "accommodation")
                                          : Accommodation{};
  const Json& configurations = value["configurations"];
  std::set<std::string> ids;
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    const Source place = where / "configurations" / i;
    if (!ids.insert(configurations[i]["id"].get<std::string>()).second)
      (place / "id").fail(configurations[i]["id"], "an id that no other configuration has");
    study.configurations.push_back(read_configuration(configurations[i], pupil_diameter_m, accommodation, place));
  }
  for (std::size_t i = 0; i < value["samplings"].size(); ++i)
    study.samplings.push_back(read_sampling(value["samplings"][i], value, where / "samplings" / i));
  study.samplers = read_words(value.value("samplers", Json({"sobol"})), where / "samplers", sequence_words);
  study.samples_per_pixel = value["samples_per_pixel"].get<std::uint64_t>();
  study.replicates = value.value("replicates", 8);
  study.max_bounces = value.value("max_bounces", study.max_bounces);
  return study;
}

}  // namespace sturm
