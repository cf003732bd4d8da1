#pragma once
#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace sturm {

using Json = nlohmann::json;  ///< members of objects are sorted by their names

/// Where a JSON value stands: its file ("<stdin>" for standard input) and its JSON pointer (RFC 6901). For error
/// messages.
struct Source {
  std::string file;     ///< as it was named
  std::string pointer;  ///< "" is the whole document

  Source operator/(std::string_view key) const;  ///< of a member of the object that stands there
  Source operator/(std::size_t index) const;     ///< of an element of the array that stands there

  /// Throws InputError for `value` at this place, cut to a readable length.
  [[noreturn]] void fail(const Json& value, const std::string& expected) const;
};

/// Reads a JSON file, or standard input for "-". Strict RFC 8259: duplicate keys, numbers beyond double, invalid UTF-8,
/// nesting deeper than 64 and texts over 256 MiB are refused; a byte-order mark is tolerated. Throws InputError.
Json load_json(const std::string& path);

/// The same for a text; `file` only names it in errors.
Json parse_json(std::string_view text, const std::string& file);

/// `value` on one line, cut to about `limit` characters.
std::string compact(const Json& value, std::size_t limit = 80);

/// The absolute path of a file that `naming_file` names; relative paths start at the folder of `naming_file`
/// (at the working directory for standard input).
std::filesystem::path path_beside(const std::string& path, const std::string& naming_file);

}  // namespace sturm
