#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/eye_spec.h"
#include "io/spectacles_spec.h"

namespace sturm {

/// An eye and what it wears, as the members "eye" and "spectacles" of a document.
struct WornEyeSpec {
  Eye eye;
  std::optional<Spectacles> spectacles;  ///< none: the naked eye
  std::vector<std::string> notes, input_files;
};

/// `parent` is the validated object that has the two members, `where` its place. Throws InputError.
WornEyeSpec read_worn_eye(const Json& parent, const Source& where);

}  // namespace sturm
