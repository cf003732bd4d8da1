#include "io/specs/worn_eye_spec.h"

#include <nlohmann/json.hpp>

namespace sturm {

WornEyeSpec read_worn_eye(const Json& parent, const Source& where, const WornEye& otherwise) {
  WornEyeSpec spec{otherwise, {}, {}};
  if (parent.contains("eye")) {
    EyeSpec eye = read_eye_spec(parent["eye"], where / "eye");
    spec.worn.eye = eye.eye;
    spec.notes = std::move(eye.notes);
    spec.input_files = std::move(eye.input_files);
  }
  if (parent.contains("spectacles")) {
    SpectaclesSpec lens = read_spectacles(parent["spectacles"], where / "spectacles", spec.worn.eye);
    spec.worn.spectacles = std::move(lens.lens);
    spec.input_files.insert(spec.input_files.end(), lens.input_files.begin(), lens.input_files.end());
    spec.notes.insert(spec.notes.end(), lens.notes.begin(), lens.notes.end());
  }
  return spec;
}

}  // namespace sturm
