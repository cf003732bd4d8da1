#include "io/specs/denoise_spec.h"

#include <nlohmann/json.hpp>

namespace sturm {

std::optional<DenoiseSpec> read_denoise(const Json& method) {
  const auto denoise = method.find("denoise");
  if (denoise == method.end()) return std::nullopt;
  DenoiseSpec spec;
  spec.levels = denoise->value("levels", spec.levels);
  spec.radiance_sigma = denoise->value("radiance_sigma", spec.radiance_sigma);
  spec.albedo_sigma = denoise->value("albedo_sigma", spec.albedo_sigma);
  spec.normal_sigma = denoise->value("normal_sigma", spec.normal_sigma);
  spec.vergence_sigma = denoise->value("vergence_sigma", spec.vergence_sigma);
  return spec;
}

}  // namespace sturm
