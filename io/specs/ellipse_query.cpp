#include "io/specs/ellipse_query.h"

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/worn_eye_spec.h"
#include "lensmodel/units.h"

namespace sturm {

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
  query.methods = document["methods"].get<std::vector<std::string>>();
  query.rays = read_ray_bundle(document.value("rays", Json()), root / "rays", query.eye.pupil_radius_m);
  query.seed = document.value("seed", query.seed);
  return query;
}

}  // namespace sturm
