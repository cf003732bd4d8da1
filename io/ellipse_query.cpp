#include "io/ellipse_query.h"

#include <nlohmann/json.hpp>

#include "io/error.h"
#include "io/schema.h"
#include "lensmodel/units.h"

namespace sturm {

EllipseQuery read_ellipse_query(const Json& document, const std::string& file) {
  validate(document, "ellipse", file);
  const Source root{file, ""};
  EllipseQuery query;
  EyeSpec eye = read_eye_spec(document["eye"], root / "eye");
  query.eye = eye.eye;
  query.notes = std::move(eye.notes);
  query.input_files = std::move(eye.input_files);
  SpectaclesSpec spectacles = read_spectacles(document.value("spectacles", Json()), root / "spectacles", query.eye);
  query.spectacles = std::move(spectacles.lens);
  query.input_files.insert(query.input_files.end(), spectacles.input_files.begin(), spectacles.input_files.end());
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
  query.methods = document["methods"].get<std::vector<std::string>>();
  query.rays = read_ray_bundle(document.value("rays", Json()), root / "rays", query.eye.pupil_radius_m);
  query.seed = document.value("seed", query.seed);
  return query;
}

}  // namespace sturm
