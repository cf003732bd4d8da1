#pragma once
#include <string>

#include "app/commands.h"
#include "io/json/json.h"

namespace sturm {

/// Gives the eye of a document, or the lens that it is, what the options say of it: prescription, vertex distance,
/// pupil, accommodation, spectacles. Throws InputError for a document that has no place for one of them.
void apply_eye_options(Json& document, const CommonOptions& options);

/// A path of the command line as the document that `options` name has to write it: documents start paths at their own
/// folder, the command line at the working directory.
std::string path_in_document(const CommonOptions& options, const std::string& path);

/// Gives an eye, an object at `where`, its pupil, its accommodation and the vertex distance of its prescription, as far
/// as these are stated. Throws InputError.
void apply_wearer(Json& eye, const WearerOptions& wearer, const Source& where);

}  // namespace sturm
