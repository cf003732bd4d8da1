#pragma once
#include <string>
#include <string_view>

#include "io/json/json.h"

namespace sturm {

/// Applies one `--set /pointer=value` to a document. The value is taken as JSON if it is JSON, else as a string.
/// Missing object members on the way are created (validate the document afterwards: it refuses unknown ones); array
/// elements must exist, "-" appends one. Throws InputError for a malformed assignment or a pointer through a value that
/// has no members.
void apply_set(Json& document, std::string_view assignment);

}  // namespace sturm
