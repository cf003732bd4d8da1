#include "io/json/data_uri.h"

#include <cctype>
#include <nlohmann/json.hpp>

#include "io/files/lower_case.h"

namespace sturm {

namespace {

int hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

int value_of_letter(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;  // '-' and '_' stand in base64 for URIs
  return c == '/' || c == '_' ? 63 : -1;
}

std::string base64_decoded(std::string_view text, const Source& where) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t gathered = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    if (std::isspace(static_cast<unsigned char>(c))) continue;
    const int value = value_of_letter(c);
    if (value < 0) where.fail(std::string(1, c), "base64 data of letters, digits, + and /");
    gathered = gathered << 6 | static_cast<std::uint32_t>(value);
    if ((bits += 6) < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(gathered >> bits & 0xFF);
  }
  return bytes;
}

}  // namespace

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hexadecimal(text[i + 1]) >= 0 && hexadecimal(text[i + 2]) >= 0) {
      decoded += static_cast<char>(16 * hexadecimal(text[i + 1]) + hexadecimal(text[i + 2]));
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

std::optional<std::string> data_of_uri(std::string_view uri, const Source& where) {
  if (lower_case(uri.substr(0, 5)) != "data:") return std::nullopt;
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) where.fail(std::string(uri.substr(0, 40)), "a data URI with a comma");
  const std::string head = lower_case(uri.substr(0, comma));
  const std::string_view body = uri.substr(comma + 1);
  if (!head.ends_with(";base64")) return percent_decoded(body);
  return body.find('%') == std::string_view::npos ? base64_decoded(body, where)
                                                  : base64_decoded(percent_decoded(body), where);
}

}  // namespace sturm
