#pragma once
#include <optional>
#include <string>

#include "io/specs/camera_spec.h"
#include "io/specs/worn_eye_spec.h"

namespace sturm {

// What the core of a viewer's page takes of a render document (viewer/src/core_module.d.ts: CameraNumbers,
// WornNumbers). `document` is the validated one, in which eye files are put in place; `file` names it in messages.

/// Throws InputError for a projection that the page does not have.
Json camera_numbers(const CameraSpec& camera, const std::string& file);

Json right_numbers(const WornEye& right, const Json& document, const std::string& file);

/// The left eye wears the right one's spectacles unless it states its own. `left`: none without a stereo pair, then
/// null.
Json left_numbers(const std::optional<WornEye>& left, const WornEye& right, const Json& document,
                  const std::string& file);

}  // namespace sturm
