#include "io/images/png_output.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/files/error.h"

namespace sturm {

namespace {

/// A file on its way through libpng, which leaves its functions by longjmp where something is wrong: whoever calls them
/// has nothing to destroy and keeps everything here.
struct PngWriting {
  const Image& display;
  int bits;
  std::vector<png_byte> rows;
  std::size_t row_bytes;
  std::string failure{};
  std::vector<unsigned char> file{};
  png_structp png = nullptr;
  png_infop info = nullptr;

  ~PngWriting() { png_destroy_write_struct(&png, &info); }
};

[[noreturn]] void note_png_failure(png_structp png, png_const_charp message) {
  static_cast<PngWriting*>(png_get_error_ptr(png))->failure = message;
  png_longjmp(png, 1);
}

void ignore_png_remark(png_structp, png_const_charp) {}

/// Whether there was room for the bytes.
bool append_bytes(std::vector<unsigned char>& file, png_const_bytep bytes, std::size_t count) {
  try {
    file.insert(file.end(), bytes, bytes + count);
    return true;
  } catch (const std::exception&) {  // which must not cross libpng's functions
    return false;
  }
}

void give_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  if (!append_bytes(static_cast<PngWriting*>(png_get_io_ptr(png))->file, bytes, count)) png_error(png, "no memory");
}

void write_all(PngWriting& writing) {
  const auto width = static_cast<png_uint_32>(writing.display.width),
             height = static_cast<png_uint_32>(writing.display.height);
  png_set_write_fn(writing.png, &writing, give_bytes, nullptr);
  png_set_IHDR(writing.png, writing.info, width, height, writing.bits,
               writing.display.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(writing.png, writing.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(writing.png, writing.info);
  for (png_uint_32 y = 0; y < height; ++y) png_write_row(writing.png, writing.rows.data() + y * writing.row_bytes);
  png_write_end(writing.png, nullptr);
}

/// Runs what calls libpng.
void guard_png_writing(PngWriting& writing) {
  if (setjmp(png_jmpbuf(writing.png))) throw RuntimeFailure("PNG encoding failed: " + writing.failure);
  write_all(writing);
}

/// Rows of integers, the most significant byte first.
template <class Integer>
std::vector<png_byte> png_rows(const Image& display) {
  constexpr auto largest = static_cast<float>(std::numeric_limits<Integer>::max());
  std::vector<png_byte> rows;
  rows.reserve(display.pixels.size() * sizeof(Integer));
  for (const float value : display.pixels) {
    if (!std::isfinite(value)) throw std::invalid_argument("a PNG cannot hold a value that is not finite");
    const auto rounded = static_cast<std::uint32_t>(std::lround(largest * std::clamp(value, 0.0f, 1.0f)));
    if constexpr (sizeof(Integer) == 2) rows.push_back(static_cast<png_byte>(rounded >> 8));
    rows.push_back(static_cast<png_byte>(rounded & 0xff));
  }
  return rows;
}

}  // namespace

std::vector<unsigned char> encode_png(const Image& display, int bits) {
  if (display.width < 1 || display.height < 1 || (display.channels != 1 && display.channels != 3))
    throw std::invalid_argument("a PNG is made of an image with 1 or 3 channels");
  if (bits != 8 && bits != 16) throw std::invalid_argument("a PNG has 8 or 16 bits");
  PngWriting writing{display, bits, bits == 8 ? png_rows<std::uint8_t>(display) : png_rows<std::uint16_t>(display),
                     static_cast<std::size_t>(display.width) * static_cast<std::size_t>(display.channels * bits / 8)};
  writing.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writing, note_png_failure, ignore_png_remark);
  writing.info = writing.png ? png_create_info_struct(writing.png) : nullptr;
  if (!writing.info) throw RuntimeFailure("PNG encoding failed: no memory");
  guard_png_writing(writing);
  return std::move(writing.file);
}

}  // namespace sturm
