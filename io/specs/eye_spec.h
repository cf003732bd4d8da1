#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/prescription_notation.h"
#include "lensmodel/eye.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// An eye as a configuration gives it, and what is remarkable about it.
struct EyeSpec {
  Eye eye;                               ///< SI units, correction at the cornea
  std::vector<std::string> notes;        ///< e.g. a pupil beyond 10 mm; for the manifest
  std::vector<std::string> input_files;  ///< absolute path of the eye's own file, if it has one
};

/// Reads an eye object or the path of an eye file (relative to `where.file`). Throws InputError.
EyeSpec read_eye_spec(const Json& value, const Source& where);

/// The eye alone.
Eye read_eye(const Json& value, const Source& where);

/// Reads a prescription as the schema of eyes defines it, an object or a text in optical notation; a cylinder needs an
/// axis, a prism a base, and the vertex distance must not lie at the lens's focal length. `eye` is the one that a text
/// for both is read for. The addition of a text counts only where it is asked for (progressive lenses).
Prescription read_prescription(const Json& value, const Source& where, std::optional<EyeSide> eye = std::nullopt);

/// Reads {"mode": "relaxed" | "fixed" | "best", …}.
Accommodation read_accommodation(const Json& value, const Source& where);

/// A distance [m]: a number > 0, or "inf".
double read_distance(const Json& value, const Source& where);

/// Eye::with, its errors turned into InputErrors about `where`.
Eye make_eye(const Prescription& rx, double pupil_diameter_m, const Accommodation& accommodation, const Source& where);

/// Throws InputError unless the ray model has rays for an eye that accommodates so.
void require_rays(RayModel ray_model, const Accommodation& accommodation, const Source& where);

/// The same, and unless an eye can accommodate so in `camera` gaze, where one accommodation holds for all distances. A
/// prediction has no ray model.
void require_camera_accommodation(const Accommodation& accommodation, std::optional<RayModel> ray_model,
                                  const Source& where);

/// The contents of the eye file that `value` names, validated; `value` itself if it is an object.
Json eye_object(const Json& value, const Source& where);

}  // namespace sturm
