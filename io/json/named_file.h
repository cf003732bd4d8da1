#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// The absolute path of the file that the string `value` names: relative to the folder of `where.file`, or, where there
/// is none, the shipped file of the same folder and name (io/files/shipped_files.h). Throws InputError about `where`
/// unless it is there.
std::filesystem::path existing_file(const Json& value, const Source& where, const char* what);

/// The same for a document of format sturm.`schema_name`/1, which may also be the plain name of a shipped one:
/// "cornell_box".
std::filesystem::path existing_document(const Json& value, const Source& where, const char* schema_name,
                                        const char* what);

/// Loads and validates the document that `value` names. Throws InputError unless it is an object that follows the
/// schema.
Json load_named_document(const Json& value, const Source& where, const char* schema_name);

/// The file that load_named_document reads.
std::filesystem::path named_document_file(const Json& value, const Source& where, const char* schema_name);

/// The folder of configs/ that has documents of this format; "" where none is shipped.
std::string shipped_kind(std::string_view schema_name);

/// Folders of configs/ whose documents can be named.
std::vector<std::string> shipped_kinds();

}  // namespace sturm
