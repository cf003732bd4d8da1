#include "experiments/figures/conoid_ellipses.h"

#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "lensmodel/units.h"
#include "stages/ellipse_stage.h"

namespace sturm {

std::vector<BlurAtDistance> conoid_ellipses(const WornEye& worn, const std::vector<Target>& targets) {
  EllipseQuery query;
  query.eye = worn.eye;
  query.spectacles = worn.spectacles;
  query.targets = targets;
  query.methods = {ConoidMethod::conoid};
  const Json answer = blur_ellipses(query);
  std::vector<BlurAtDistance> ellipses;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Json& result = answer["results"][i];
    BlurAtDistance blur;
    blur.distance_m = targets[i].distance_m;
    blur.accommodation_D = number_at(result, "accommodation_D");
    blur.orientation_deg = number_at(result, "orientation_deg");
    if (const Json& axes = result["semi_axes_rad"]; axes.is_array()) {
      blur.semi_major_arcmin = arcminutes_per_radian * axes[0].get<double>();
      blur.semi_minor_arcmin = arcminutes_per_radian * axes[1].get<double>();
    }
    ellipses.push_back(blur);
  }
  return ellipses;
}

}  // namespace sturm
