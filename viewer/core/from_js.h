#pragma once
#include <emscripten/val.h>

#include <optional>

#include "conoid/blur_field/field_grid.h"
#include "conoid/pictures/sight_field.h"
#include "lensmodel/eye.h"
#include "lensmodel/spectacles.h"

namespace sturm::viewer {

// What the page hands over, by the names of viewer/src/core_module.d.ts. All of them throw std::invalid_argument or
// std::domain_error for numbers that no eye, lens or picture has.

/// An `EyeNumbers`.
Eye read_eye(const emscripten::val& numbers);

/// A `LensNumbers` for this eye; null is none.
std::optional<Spectacles> read_lens(const emscripten::val& numbers, const Eye& eye);

/// A `GridNumbers`.
FieldGrid read_grid(const emscripten::val& numbers);

/// A `CameraNumbers`.
PicturePlane read_camera(const emscripten::val& numbers);

/// "camera" or "foveal".
Gaze read_gaze(const emscripten::val& word);

}  // namespace sturm::viewer
