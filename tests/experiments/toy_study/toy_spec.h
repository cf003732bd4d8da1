#pragma once
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// What the toy study asks: how large is the blur of a distant point for an eye that is out of focus by so much?
struct ToyStudySpec {
  double pupil_diameter_m = 0.0;
  std::vector<double> defocus_D;
};

/// Reads a section "toy_study". Throws InputError for a pupil that is not there.
ToyStudySpec read_toy_study(const Json& value, const Source& where);

}  // namespace sturm
