#include "io/specs/progressive_spec.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "lensmodel/units.h"

namespace sturm {

ProgressiveDesign read_progressive_design(const Json& value, const Source& where, const SingleVisionDesign& lens) {
  const auto metres = [&](const char* key, double default_mm) {
    return metres_per_millimetre * value.value(key, default_mm);
  };
  ProgressiveDesign design;
  design.lens = lens;
  design.addition_D = value["addition_D"].get<double>();
  design.corridor_start_m = metres("corridor_start_mm", 0.0);
  design.corridor_length_m = metres("corridor_length_mm", 18.0);
  design.knot_spacing_m = metres("knot_spacing_mm", 0.125);
  // The nose is on the wearer's left of a right eye.
  const double towards_nose = value.value("eye", std::string("right")) == "right" ? -1.0 : 1.0;
  design.near_shift_m = towards_nose * metres("inset_mm", 2.5);
  const auto width = value.find("zone_width_mm");
  if (width == value.end())
    design.zone_width_m = 10.0 * metres_per_millimetre;
  else if (!width->is_null())
    design.zone_width_m = metres_per_millimetre * width->get<double>();
  const double lowest = design.corridor_length_m - design.corridor_start_m;
  if (!(std::abs(design.near_shift_m) < 0.5 * lowest) && design.near_shift_m != 0.0)
    (where / "inset_mm")
        .fail(value.value("inset_mm", Json(2.5)),
              "less than half of how far the corridor's lower end is below the fitting cross");
  if (!(design.knot_spacing_m <= 0.05 * lens.diameter_m && design.knot_spacing_m >= lens.diameter_m / 2000.0))
    (where / "knot_spacing_mm")
        .fail(value.value("knot_spacing_mm", Json(0.125)), "between 1/2000 and 1/20 of the rim's diameter");
  return design;
}

}  // namespace sturm
