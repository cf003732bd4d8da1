#pragma once
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// A document of point spreads and its sturm.psf_result/1.
struct NamedSpreads {
  std::string name;
  Json result;
};

/// Point spreads for people: a line for each light, target and model with Strehl ratios, radii that hold shares of the
/// energy [arcmin] about the chief ray, and the modulation transfer, of which the mean over the directions is shown.
std::string psf_table(const std::vector<NamedSpreads>& documents);

/// Point spreads for programs: the same lines, and the modulation transfer of each direction, with the units of the
/// result.
std::string psf_csv(const std::vector<NamedSpreads>& documents);

}  // namespace sturm
