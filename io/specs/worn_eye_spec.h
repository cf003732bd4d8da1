#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/specs/eye_spec.h"
#include "io/specs/spectacles_spec.h"

namespace sturm {

/// An eye and what it wears.
struct WornEye {
  Eye eye;
  std::optional<Spectacles> spectacles;  ///< none: the naked eye
};

/// The members "eye" and "spectacles" of a document, and what reading them brought along.
struct WornEyeSpec {
  WornEye worn;
  std::vector<std::string> notes, input_files;
};

/// `parent` is the validated object that has the two members, `where` its place; what it lacks is taken from
/// `otherwise`. Throws InputError.
WornEyeSpec read_worn_eye(const Json& parent, const Source& where, const WornEye& otherwise = {});

}  // namespace sturm
