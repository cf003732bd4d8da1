#include "io/json/json_pointer_set.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/files/error.h"

namespace sturm {

namespace {

std::vector<std::string> tokens_of(std::string_view pointer) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < pointer.size();) {
    const std::size_t end = std::min(pointer.find('/', at + 1), pointer.size());
    std::string token;
    for (std::size_t i = at + 1; i < end; ++i) {
      if (pointer[i] != '~') {
        token += pointer[i];
        continue;
      }
      const char code = i + 1 < end ? pointer[++i] : '?';
      if (code != '0' && code != '1')
        throw InputError("--set", std::string(pointer), "~" + std::string(1, code), "~0 (for ~) or ~1 (for /)");
      token += code == '0' ? '~' : '/';
    }
    tokens.push_back(token);
    at = end;
  }
  return tokens;
}

Json& element_of(Json& array, const std::string& token, const Source& where) {
  if (token == "-") {
    array.push_back(nullptr);
    return array.back();
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  if (token.empty() || error != std::errc() || end != token.data() + token.size() || index >= array.size())
    throw InputError(where.file, where.pointer, "index \"" + token + "\"",
                     array.empty() ? "- (append) in an empty array"
                                   : "an index from 0 to " + std::to_string(array.size() - 1) + ", or - to append");
  return array[index];
}

Json value_of(std::string_view text) {
  try {
    return parse_json(text, "--set");
  } catch (const InputError&) {
    return Json(std::string(text));
  }
}

/// Text that JSON cannot hold would only be noticed when the document is written.
void require_utf8(std::string_view text) {
  try {
    Json(std::string(text)).dump();
  } catch (const Json::type_error&) {
    throw InputError("--set", "", "bytes that are not UTF-8", "/pointer=value in UTF-8");
  }
}

}  // namespace

void apply_set(Json& document, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (assignment.empty() || assignment[0] != '/' || equals == std::string_view::npos)
    throw InputError("--set", "", "\"" + std::string(assignment) + "\"", "/pointer=value");
  require_utf8(assignment);
  Json* place = &document;
  Source where{"--set", ""};
  for (const std::string& token : tokens_of(assignment.substr(0, equals))) {
    if (place->is_null()) *place = Json::object();
    if (place->is_object())
      place = &(*place)[token];
    else if (place->is_array())
      place = &element_of(*place, token, where);
    else
      where.fail(*place, "an object or array, to set \"" + token + "\" in it");
    where = where / token;
  }
  *place = value_of(assignment.substr(equals + 1));
}

}  // namespace sturm
