#include "io/json/json.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/files/sandbox.h"
#include "io/files/text_encoding.h"
#include "io/json/foreign_file.h"
#include "io/json/json_text.h"

namespace sturm {

namespace {

constexpr std::size_t max_text_bytes = std::size_t{256} << 20;
constexpr std::size_t max_depth = 64;  // readers and schema walks recurse

std::string escaped(std::string_view key) {
  std::string token;
  for (const char c : key) {
    if (c == '~')
      token += "~0";
    else if (c == '/')
      token += "~1";
    else
      token += c;
  }
  return token;
}

constexpr std::size_t shown_bytes = 160;

/// What stands in a JSON text where no such character may stand, if that is not ASCII: a typographic sign, or a byte
/// that is no UTF-8.
std::optional<std::string> foreign_character(std::string_view text) {
  if (text.empty() || static_cast<unsigned char>(text[0]) < 0x80) return std::nullopt;
  for (std::size_t size = 2; size <= std::min<std::size_t>(4, text.size()); ++size)
    if (is_utf8(text.substr(0, size))) return "\"" + std::string(text.substr(0, size)) + "\"";
  return "an invalid byte (the text is not UTF-8)";
}

/// The character of `text` that the byte at `at` belongs to.
std::string_view from_character_start(std::string_view text, std::size_t at) {
  std::size_t start = std::min(at, text.size());
  while (start > 0 && start + 3 > at && start < text.size() && (static_cast<unsigned char>(text[start]) & 0xC0) == 0x80)
    --start;
  return text.substr(start);
}

/// Which key of the keyboard was meant.
std::string keyboard_hint(std::string_view character) {
  const std::string sign = with_keyboard_signs(character.substr(1, character.size() - 2));
  if (sign == "-" || sign == "+" || sign == " ") return ", with the \"" + sign + "\" of the keyboard";
  for (const char* quote : {"\u201C", "\u201D", "\u201E", "\u2018", "\u2019", "\u00AB", "\u00BB"})
    if (character.substr(1, character.size() - 2) == quote) return ", with the quotes of the keyboard";
  return "";
}

/// First pass over a text: finds what nlohmann's own parser lets through (duplicate keys, deep nesting) and turns its
/// exceptions into file:line:column.
class StrictCheck : public nlohmann::json_sax<Json> {
 public:
  StrictCheck(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return open(); }
  bool start_array(std::size_t) override {
    open();
    levels_.back().is_array = true;
    return true;
  }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.key = name;
    if (!level.keys.insert(name).second)
      throw InputError(file_, pointer(), "a second \"" + name + "\"", "each key at most once");
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& error) override {
    // byte counts from 1 and is the last byte read; past the end of the text for a text that stops early.
    const std::string_view before = text_.substr(0, std::min(byte > 0 ? byte - 1 : 0, text_.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0
    std::string what = error.what();
    // "[json.exception.…] parse error at line 1, column 2: syntax error …; expected …"
    if (const auto bracket = what.find("] "); bracket != std::string::npos) what.erase(0, bracket + 2);
    if (what.starts_with("parse error"))
      if (const auto colon = what.find(": "); colon != std::string::npos) what.erase(0, colon + 2);
    std::string expected = "JSON (RFC 8259)";
    if (const auto semicolon = what.find("; expected "); semicolon != std::string::npos) {
      expected = what.substr(semicolon + 11);
      what.erase(semicolon);
    }
    // nlohmann quotes the text up to the byte that it could not use, which may be the first one of a character.
    if (const auto foreign = foreign_character(from_character_start(text_, byte > 0 ? byte - 1 : 0))) {
      what = *foreign;
      expected += keyboard_hint(*foreign);
    }
    throw InputError(file_ + ":" + std::to_string(line) + ":" + std::to_string(before.size() - line_start + 1), "",
                     readable(utf8_text(what), shown_bytes), expected);
  }

 private:
  struct Level {
    bool is_array = false;
    std::size_t index = 0;  // of an array's current element
    std::string key;        // of an object's current member
    std::set<std::string> keys;
  };

  bool value() {
    if (!levels_.empty()) ++levels_.back().index;
    return true;
  }
  bool open() {
    if (levels_.size() >= max_depth)
      throw InputError(file_, pointer(), "", "at most " + std::to_string(max_depth) + " nested objects and arrays");
    levels_.emplace_back();
    return true;
  }
  bool close() {
    levels_.pop_back();
    return value();
  }
  std::string pointer() const {
    std::string text;
    for (const Level& level : levels_)
      text += "/" + (level.is_array ? std::to_string(level.index) : escaped(level.key));
    return text;
  }

  std::string_view text_;
  const std::string& file_;
  std::vector<Level> levels_;
};

std::string read_all(std::istream& stream, const std::string& file) {
  std::string text;
  std::vector<char> piece(1 << 16);
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_text_bytes) throw InputError(file, "", "more than 256 MiB", "a smaller JSON text");
  }
  return text;
}

}  // namespace

Source Source::operator/(std::string_view key) const {
  return {file, pointer + "/" + escaped(key)};
}

Source Source::operator/(std::size_t index) const {
  return {file, pointer + "/" + std::to_string(index)};
}

void Source::fail(const Json& value, const std::string& expected) const {
  throw InputError(file, pointer, compact(value), expected);
}

Json parse_json(std::string_view text, const std::string& file) {
  StrictCheck check(text, file);
  Json::sax_parse(text, &check);
  return Json::parse(text);
}

Json load_json(const std::string& path) {
  if (path == "-") return parse_json(read_all(std::cin, "<stdin>"), "<stdin>");
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) throw InputError(path, "", "a folder", "a JSON file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path, "", std::strerror(errno), "a readable JSON file");
  const std::string text = read_all(stream, path);
  if (const std::string kind = other_kind_of_file(text); !kind.empty())
    throw InputError(path, "", kind, "a JSON document");
  return parse_json(text, path);
}

std::string compact(const Json& value, std::size_t limit) {
  // A big array is cut before it is printed: only `limit` characters will be shown.
  std::string text;
  if (value.is_array() && value.size() > limit)
    text = Json(Json::array_t(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(limit))).dump();
  else
    text = json_text(value);
  if (text.size() <= limit) return text;
  std::size_t end = limit - 1;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside a UTF-8 sequence
  return text.substr(0, end) + "…";
}

std::filesystem::path path_beside(const std::string& path, const std::string& naming_file) {
  const std::filesystem::path folder =
      naming_file == "<stdin>" ? std::filesystem::path() : std::filesystem::path(naming_file).parent_path();
  const std::filesystem::path found = std::filesystem::absolute(folder / path).lexically_normal();
  if (!within_sandbox(found, naming_file))
    throw InputError(naming_file, "", path, "with --sandbox a file in the folder of the file that names it, or below");
  return found;
}

}  // namespace sturm
