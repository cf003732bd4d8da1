#pragma once
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/spectacles_spec.h"
#include "lensmodel/eye.h"

namespace sturm {

/// The class Eye of Python.
struct EyeObject {
  Eye eye;
  std::vector<std::string> notes;
};

/// The class Spectacles of Python; `spec.lens` is there.
struct SpectaclesObject {
  SpectaclesSpec spec;
};

}  // namespace sturm
