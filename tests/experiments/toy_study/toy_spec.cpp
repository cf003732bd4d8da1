#include "experiments/toy_study/toy_spec.h"

#include <nlohmann/json.hpp>

namespace sturm {

ToyStudySpec read_toy_study(const Json& value, const Source& where) {
  ToyStudySpec spec;
  spec.pupil_diameter_m = 1e-3 * value.at("pupil_diameter_mm").get<double>();
  if (!(spec.pupil_diameter_m > 0.0))
    (where / "pupil_diameter_mm").fail(value.at("pupil_diameter_mm"), "a diameter above 0");
  spec.defocus_D = value.at("defocus_D").get<std::vector<double>>();
  return spec;
}

}  // namespace sturm
