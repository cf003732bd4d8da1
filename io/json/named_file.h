#pragma once
#include <filesystem>

#include "io/json/json.h"

namespace sturm {

/// The absolute path of the file that the string `value` names, relative to the folder of `where.file`. Throws
/// InputError about `where` unless it is there.
std::filesystem::path existing_file(const Json& value, const Source& where, const char* what);

/// Loads and validates the document in the file that `value` names. Throws InputError unless it is an object that
/// follows the schema.
Json load_named_document(const Json& value, const Source& where, const char* schema_name);

}  // namespace sturm
