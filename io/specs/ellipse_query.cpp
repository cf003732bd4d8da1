#include "io/specs/ellipse_query.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/words.h"
#include "io/specs/worn_eye_spec.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr std::string_view ray_prefix = "rays:";

EllipseMethod read_method(const Json& value, const Source& where) {
  const auto& word = value.get_ref<const std::string&>();
  if (!word.starts_with(ray_prefix)) return read_word(value, where, conoid_method_words);
  return read_word(word.substr(ray_prefix.size()), where, ray_model_words);
}

}  // namespace

std::string name_of(const EllipseMethod& method) {
  if (const auto* conoid = std::get_if<ConoidMethod>(&method)) return std::string(conoid_method_words.word_of(*conoid));
  return std::string(ray_prefix) + name_of(std::get<RayModel>(method));
}

EllipseQuery read_ellipse_query(const Json& document, const std::string& file) {
  validate(document, "ellipse", file);
  const Source root{file, ""};
  EllipseQuery query;
  WornEyeSpec read = read_worn_eye(document, root);
  query.eye = read.worn.eye;
  query.spectacles = std::move(read.worn.spectacles);
  query.notes = std::move(read.notes);
  query.input_files = std::move(read.input_files);
  const Json& targets = document["targets"];
  for (std::size_t i = 0; i < targets.size(); ++i) {
    Target target;
    if (const auto gaze = targets[i].find("gaze_deg"); gaze != targets[i].end()) {
      target.azimuth = radians_per_degree * (*gaze)[0].get<double>();
      target.elevation = radians_per_degree * (*gaze)[1].get<double>();
    }
    target.distance_m = read_distance(targets[i]["distance_m"], root / "targets" / i / "distance_m");
    query.targets.push_back(target);
  }
  for (std::size_t i = 0; i < document["methods"].size(); ++i)
    query.methods.push_back(read_method(document["methods"][i], root / "methods" / i));
  query.rays = read_ray_bundle(document.value("rays", Json()), root / "rays", query.eye.pupil_radius_m);
  query.seed = document.value("seed", query.seed);
  return query;
}

}  // namespace sturm
