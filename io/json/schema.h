#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// File name (ellipse.schema.json) and text of every schema of configs/schemas, compiled in.
const std::vector<std::pair<std::string_view, std::string_view>>& embedded_schemas();

/// Names of all schemas, sorted: "ellipse", "ellipse_result", … A document of format "sturm.NAME/1" follows schema
/// NAME.
std::vector<std::string> schema_names();

/// The self-contained schema (JSON Schema draft 7): references to other schema files are hoisted into its
/// `definitions`. Throws InputError for an unknown name, listing the known ones.
Json schema_document(std::string_view name);

/// `schema_document` as indented text.
std::string schema_text(std::string_view name);

/// Name of the schema that `document` declares by its "format". Throws InputError listing the known formats.
std::string format_of(const Json& document, const std::string& file);

/// Checks a document against a schema. Throws InputError for the first violation: unknown keys first (with a
/// suggestion), then types, ranges and missing members, with pointer, value and what the schema says about that place.
void validate(const Json& document, std::string_view schema_name, const std::string& file);

/// The same for a document that stands inside of another one, at `root`.
void validate(const Json& document, std::string_view schema_name, const Source& root);

/// A valid document with every default that the schema states spelt out.
Json with_defaults(const Json& document, std::string_view schema_name);

/// The same for a value that follows one of the schema's definitions.
Json with_defaults(const Json& value, std::string_view schema_name, const std::string& definition);

}  // namespace sturm
