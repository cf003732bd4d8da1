#include "io/images/png_output.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/files/gzip.h"

namespace sturm {

namespace {

template <class Integer>
void append_big_endian(std::string& bytes, Integer number) {
  for (int shift = std::numeric_limits<Integer>::digits - 8; shift >= 0; shift -= 8)
    bytes += static_cast<char>(number >> shift & 0xff);
}

/// A chunk by its type and data (PNG Specification, Third Edition, 5.3).
void append_chunk(std::string& file, const std::string& type_and_data) {
  append_big_endian(file, static_cast<std::uint32_t>(type_and_data.size() - 4));
  file += type_and_data;
  const auto* bytes = reinterpret_cast<const Bytef*>(type_and_data.data());
  append_big_endian(file, static_cast<std::uint32_t>(crc32_z(0, bytes, type_and_data.size())));
}

std::string png_header_chunk(const Image& display, int bits) {
  std::string chunk = "IHDR";
  append_big_endian(chunk, static_cast<std::uint32_t>(display.width));
  append_big_endian(chunk, static_cast<std::uint32_t>(display.height));
  constexpr char grey = 0, colour = 2;
  for (const char byte : {static_cast<char>(bits), display.channels == 1 ? grey : colour, '\0', '\0', '\0'})
    chunk += byte;
  return chunk;
}

/// Rows of integers, the most significant byte first, each behind its filter: none.
template <class Integer>
std::string png_rows(const Image& display) {
  constexpr auto largest = static_cast<float>(std::numeric_limits<Integer>::max());
  const std::size_t row = static_cast<std::size_t>(display.width) * static_cast<std::size_t>(display.channels);
  std::string rows;
  rows.reserve(display.pixels.size() * sizeof(Integer) + static_cast<std::size_t>(display.height));
  for (std::size_t i = 0; i < display.pixels.size(); ++i) {
    if (i % row == 0) rows += '\0';
    const float value = display.pixels[i];
    if (!std::isfinite(value)) throw std::invalid_argument("a PNG cannot hold a value that is not finite");
    append_big_endian(rows, static_cast<Integer>(std::lround(largest * std::clamp(value, 0.0f, 1.0f))));
  }
  return rows;
}

}  // namespace

std::vector<unsigned char> encode_png(const Image& display, int bits) {
  if (display.width < 1 || display.height < 1 || (display.channels != 1 && display.channels != 3))
    throw std::invalid_argument("a PNG is made of an image with 1 or 3 channels");
  if (bits != 8 && bits != 16) throw std::invalid_argument("a PNG has 8 or 16 bits");
  using namespace std::string_literals;
  std::string file = "\x89PNG\r\n\x1a\n";
  append_chunk(file, png_header_chunk(display, bits));
  append_chunk(file, "gAMA\0\0\xb1\x8f"s);  // 1/2.2, for programs that do not know the next chunk
  append_chunk(file, "sRGB\0"s);            // perceptual
  const std::string data = deflated(bits == 8 ? png_rows<std::uint8_t>(display) : png_rows<std::uint16_t>(display));
  constexpr std::size_t piece = 1 << 20;
  for (std::size_t at = 0; at < data.size(); at += piece) append_chunk(file, "IDAT" + data.substr(at, piece));
  append_chunk(file, "IEND");
  return {file.begin(), file.end()};
}

}  // namespace sturm
