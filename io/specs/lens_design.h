#pragma once
#include <optional>

#include "io/json/json.h"
#include "lensmodel/eye.h"
#include "lensmodel/progressive.h"

namespace sturm {

/// What a single-vision or progressive lens is made from.
struct LensDesign {
  Prescription power;                            ///< at its back vertex
  SingleVisionDesign lens;                       ///< of a progressive one: its far zone
  std::optional<ProgressiveDesign> progressive;  ///< none: single vision
};

/// The design of a lens that read_spectacles (io/specs/spectacles_spec.h) takes; none where it is stated by its
/// surfaces or by a file of the trade, and for null. Throws InputError.
std::optional<LensDesign> read_lens_design(const Json& value, const Source& where, const Eye& eye);

}  // namespace sturm
