#include "compare/findings/noise_floor.h"

#include "io/json/stored.h"

namespace sturm {

void add_noise_floor(const Json& entry, const std::string& name, const Number& replicates, const Measurement& about,
                     Measurements& out) {
  const Json& floor = value_at(entry, "noise_floor");
  if (!floor.is_object()) return;
  for (const auto& [key, value] : floor.items()) {
    Measurement m = about;
    m.quantity = "noise floor of " + key;
    m.value = number_at(value, "");
    m.standard_error = number_at(entry, "noise_floor_uncertainty/" + key);
    m.degrees = replicates && *replicates > 3.0 ? Number(*replicates - 2.0) : std::nullopt;
    m.better = key.starts_with("ssim") ? Better::More : Better::Less;
    m.run_name = name + m.quantity;
    out.push_back(std::move(m));
  }
}

}  // namespace sturm
