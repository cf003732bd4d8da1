#pragma once
#include <string>

#include "app/commands.h"
#include "io/json/json.h"

namespace sturm {

/// Gives the eye of a document, or the lens that it is, what the options say of it: prescription, vertex distance,
/// pupil, accommodation, spectacles. Throws InputError for a document that has no place for one of them.
void apply_eye_options(Json& document, const CommonOptions& options);

/// The same for an eye that stands alone.
void apply_eye_options_to(Json& eye, const CommonOptions& options, const Source& where);

/// Gives an eye, an object at `where`, its pupil, its accommodation and the vertex distance of its prescription, as far
/// as these are stated. Throws InputError.
void apply_wearer(Json& eye, const WearerOptions& wearer, const Source& where);

}  // namespace sturm
