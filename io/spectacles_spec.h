#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json.h"
#include "lensmodel/eye.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// Spectacles as a configuration gives them.
struct SpectaclesSpec {
  std::optional<Spectacles> lens;        ///< none: the naked eye
  std::vector<std::string> input_files;  ///< absolute path of the lens's own file, if it has one
};

/// Reads a validated lens object, the path of a lens file (relative to `where.file`), or null. A single-vision lens without a prescription
/// gets the back vertex power that `eye` needs at the lens's vertex distance. Throws InputError.
SpectaclesSpec read_spectacles(const Json& value, const Source& where, const Eye& eye);

}  // namespace sturm
