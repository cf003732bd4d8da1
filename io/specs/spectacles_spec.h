#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/free_form_fit.h"
#include "lensmodel/eye.h"
#include "lensmodel/lens_material.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// Spectacles as a configuration gives them.
struct SpectaclesSpec {
  std::optional<Spectacles> lens;        ///< none: the naked eye
  std::vector<std::string> input_files;  ///< absolute paths of the lens's own files and of its sag grids, if it has any
  std::optional<Prescription> made_for;  ///< back vertex power that a single-vision or progressive lens was made for
  std::optional<LensMaterial> material;  ///< if it was named instead of its refractive index
  std::vector<FreeFormFit> fits;         ///< of the lens's free-form surfaces
  std::vector<std::string> notes;        ///< e.g. an addition that a single-vision lens does not have
};

/// Reads a validated lens object, the path of a lens file (relative to `where.file`) in JSON or in a format of the
/// trade (io/specs/lens_files/), or null. A single-vision or progressive lens without a prescription gets the back
/// vertex power that `eye` needs at the lens's vertex distance. Throws InputError.
SpectaclesSpec read_spectacles(const Json& value, const Source& where, const Eye& eye);

/// The same for a lens without an eye: null and a maker without a prescription are refused.
SpectaclesSpec read_lens_alone(const Json& value, const Source& where);

}  // namespace sturm
