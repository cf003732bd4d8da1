#pragma once
#include <string>
#include <string_view>

#include "io/json/json.h"

namespace sturm {

/// Follows `node`'s "$ref" into the definitions of `schema`; `node` itself where it has none.
const Json& dereferenced(const Json& node, const Json& schema);

/// What the (dereferenced) schema `node` says about a member of an object or an element of an array; null if nothing.
const Json* child_schema(const Json& node, std::string_view token, bool object);

/// The demands of one (dereferenced) schema node in words: type, range, choices, then its description.
std::string expectation(const Json& node);

}  // namespace sturm
