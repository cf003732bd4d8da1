#include "io/worn_eye_spec.h"

#include <nlohmann/json.hpp>

namespace sturm {

WornEyeSpec read_worn_eye(const Json& parent, const Source& where) {
  EyeSpec eye = read_eye_spec(parent["eye"], where / "eye");
  WornEyeSpec worn{eye.eye, {}, std::move(eye.notes), std::move(eye.input_files)};
  SpectaclesSpec spectacles = read_spectacles(parent.value("spectacles", Json()), where / "spectacles", worn.eye);
  worn.spectacles = std::move(spectacles.lens);
  worn.input_files.insert(worn.input_files.end(), spectacles.input_files.begin(), spectacles.input_files.end());
  return worn;
}

}  // namespace sturm
