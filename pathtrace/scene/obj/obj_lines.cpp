#include "pathtrace/scene/obj/obj_lines.h"

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "io/files/error.h"
#include "pathtrace/scene/obj/obj_words.h"

namespace sturm {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw InputError(file.string(), "", "", "a file that can be read");
  std::string bytes(std::filesystem::file_size(file), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) return put(code);
  if (code < 0x800) return put(0xC0 | code >> 6), put(0x80 | (code & 0x3F));
  if (code < 0x10000) return put(0xE0 | code >> 12), put(0x80 | (code >> 6 & 0x3F)), put(0x80 | (code & 0x3F));
  put(0xF0 | code >> 18), put(0x80 | (code >> 12 & 0x3F)), put(0x80 | (code >> 6 & 0x3F)), put(0x80 | (code & 0x3F));
}

/// UTF-16 behind its byte order mark as UTF-8.
std::string from_utf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t i) {
    const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<std::uint32_t>(big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    }
    append_utf8(text, code);
  }
  return text;
}

}  // namespace

ObjLines::ObjLines(const std::filesystem::path& file) : file_(file), bytes_(bytes_of(file)) {
  if (bytes_.starts_with("\xFF\xFE") || bytes_.starts_with("\xFE\xFF"))
    bytes_ = from_utf16(bytes_, bytes_.starts_with("\xFE\xFF"));
  rest_ = bytes_;
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

std::string_view ObjLines::take_line() {
  std::size_t end = 0;
  while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
  const std::size_t behind = std::min(rest_.size(), end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1));
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(behind);
  ++taken_;
  return line;
}

bool ObjLines::next() {
  while (!rest_.empty()) {
    text_ = trimmed(take_line());
    number_ = taken_;
    if (text_.empty() || text_.front() == '#') continue;
    if (text_.back() != '\\') return true;
    joined_.clear();
    while (!text_.empty() && text_.back() == '\\') {
      joined_.append(text_.substr(0, text_.size() - 1)) += ' ';
      text_ = rest_.empty() ? std::string_view() : trimmed(take_line());
    }
    joined_.append(text_);
    text_ = trimmed(joined_);
    if (!text_.empty()) return true;
  }
  return false;
}

}  // namespace sturm
