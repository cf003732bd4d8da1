#pragma once
#include <optional>

#include "io/json/json.h"

namespace sturm {

/// Options of the edge-avoiding à-trous filter (pathtrace/film/denoiser.h).
struct DenoiseSpec {
  int levels = 5;                ///< steps 1, 2, 4, … 2^(levels − 1) px
  double radiance_sigma = 2.0;   ///< in standard errors of the difference of two pixels
  double albedo_sigma = 0.1;     ///< difference of albedos
  double normal_sigma = 0.3;     ///< length of the difference of unit normals
  double vergence_sigma = 0.05;  ///< relative difference of 1/distance
};

/// Reads method.denoise where it is.
std::optional<DenoiseSpec> read_denoise(const Json& method);

}  // namespace sturm
