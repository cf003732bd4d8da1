#pragma once
#include <string>

#include "io/json/json.h"

namespace sturm {

/// Throws InputError, with the command that takes it, for a document of a known format other than sturm.`schema`/1.
/// Whatever else may be wrong is left to the reader. `schema` may be "": any.
void require_kind(const Json& document, const std::string& schema, const std::string& file);

/// Reads a document by its own format, as its command would, and forgets it. Throws InputError for what is wrong.
void read_as_its_format(const Json& document, const std::string& file);

}  // namespace sturm
