#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "io/specs/scene_spec.h"

namespace sturm {

/// Reads the picture of an environment, which has a file: three finite channels ≥ 0, linear. Integers mean what its
/// `encoding` says. Values outside of its `clamp` are moved to its ends and counted in `notes`, as is what was
/// converted on reading. Throws InputError with the pixel for other values that are no radiances (NaN always).
std::shared_ptr<const Image> read_environment_picture(const EnvironmentSpec& environment,
                                                      std::vector<std::string>& notes);

}  // namespace sturm
