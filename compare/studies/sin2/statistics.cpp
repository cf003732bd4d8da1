#include "compare/studies/sin2/statistics.h"

#include <nlohmann/json.hpp>

#include "io/json/stored.h"

namespace sturm {

void add_sin2_study(const Json& report, Statistics& out) {
  const Json& checks = value_at(report, "sin2_study/checks");
  if (!checks.is_object()) return;
  for (const auto& [name, check] : checks.items()) {
    if (name.starts_with("mutant_")) continue;  // those are in the report's list "must_fail"
    Statistic s;
    s.value = number_at(check, "value");
    s.cases = static_cast<std::uint64_t>(number_at(check, "cases").value_or(0.0));
    s.worst_case = text_at(check, "worst_case");
    out["sin2_study/" + name] = s;
  }
  Extreme rose(Extreme::Of::Smallest), repaired;
  for (const Json& view : array_at(report, "sin2_study/gallery"))
    for (const Json& psf : array_at(view, "models")) {
      const std::string model = text_at(psf, "model");
      const Number over_noise = number_at(psf, "total_variation_over_noise");
      const bool astigmatic = number_at(view, "cylinder_D").value_or(1.0) != 0.0;
      if (model == "sin2_radial" && astigmatic) rose.add(over_noise, text_at(view, "id"));
      if (model == "repaired") repaired.add(over_noise, text_at(view, "id"));
    }
  out["sin2_study/gallery_sin2_over_noise_min"] = rose.result();
  out["sin2_study/gallery_repaired_over_noise_max"] = repaired.result();
}

}  // namespace sturm
