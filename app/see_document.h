#pragma once
#include "app/commands.h"
#include "io/json/json.h"

namespace sturm {

/// The same options with the document as their file: the one that was given in place of a picture, or
/// `command_line_source`.
CommonOptions with_see_source(const CommonOptions& common, const SeeOptions& options);

/// The document (sturm.see/1) that a line of `sturm see` stands for; `common` is of with_see_source. Throws InputError.
Json see_document(const CommonOptions& common, const SeeOptions& options);

}  // namespace sturm
