#include "io/images/png_input.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "io/images/big_endian.h"

namespace sturm {

namespace {

/// Whether a chunk before the pixels has EXIF or XMP data. Throws where one breaks off: libpng would make room for what
/// it claims to hold.
bool says_more(const BytesAt& bytes_at) {
  constexpr std::string_view xmp = "XML:com.adobe.xmp";
  for (std::uint64_t at = 8;;) {
    const std::string chunk = bytes_at(at, 8 + xmp.size());
    if (chunk.size() < 8) return false;
    const std::uint64_t length = big_endian(chunk, 0, 4);
    const std::string_view kind = std::string_view(chunk).substr(4, 4);
    if (kind == "IDAT") return false;
    if (bytes_at(at + 11 + length, 1).empty()) throw std::runtime_error("a chunk that breaks off");
    if (kind == "eXIf" || (kind == "iTXt" && chunk.compare(8, xmp.size(), xmp) == 0)) return true;
    at += 12 + length;
  }
}

/// A file on its way through libpng, which leaves its functions by longjmp where something is wrong: whoever calls them
/// has nothing to destroy and keeps everything here.
struct PngReading {
  const BytesAt& bytes_at;
  std::uint64_t most_pixels;
  std::uint64_t at = 0;
  std::string failure{};
  png_structp png = nullptr;
  png_infop info = nullptr;
  int passes = 1;
  std::vector<png_byte> rows{};
  StoredPng stored{};

  ~PngReading() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void note_failure(png_structp png, png_const_charp message) {
  static_cast<PngReading*>(png_get_error_ptr(png))->failure = message;
  png_longjmp(png, 1);
}

void ignore_remark(png_structp, png_const_charp) {}

/// Whether that many bytes were there.
bool copy_bytes(PngReading& reading, png_bytep to, std::size_t count) {
  try {
    const std::string bytes = reading.bytes_at(reading.at, count);
    std::memcpy(to, bytes.data(), bytes.size());
    reading.at += bytes.size();
    return bytes.size() == count;
  } catch (const std::exception&) {  // which must not cross libpng's functions
    return false;
  }
}

void take_bytes(png_structp png, png_bytep to, std::size_t count) {
  if (!copy_bytes(*static_cast<PngReading*>(png_get_io_ptr(png)), to, count)) png_error(png, "pixels that break off");
}

/// Runs what calls libpng. Throws what it has to say if it leaves early.
void guard_png(PngReading& reading, void (*work)(PngReading&)) {
  if (setjmp(png_jmpbuf(reading.png))) throw std::runtime_error(reading.failure);
  work(reading);
}

void read_png_header(PngReading& reading) {
  constexpr png_alloc_size_t most_of_a_chunk = 1 << 26;  // compressed ones are short beside what they stand for
  png_set_chunk_malloc_max(reading.png, most_of_a_chunk);
  png_set_read_fn(reading.png, &reading, take_bytes);
  png_read_info(reading.png, reading.info);
}

void keep_profile(PngReading& reading) {
  png_charp name = nullptr;
  png_bytep profile = nullptr;
  png_uint_32 size = 0;
  int compression = 0;
  if (png_get_iCCP(reading.png, reading.info, &name, &compression, &profile, &size))
    reading.stored.profile.assign(reinterpret_cast<const char*>(profile), size);
}

/// Every pixel is to have 8 or 16 bits in each of its channels.
void ask_for_channels(PngReading& reading) {
  png_set_expand(reading.png);
  reading.passes = png_set_interlace_handling(reading.png);
  png_read_update_info(reading.png, reading.info);
}

/// Rows go into the picture as they come; those of interlaced files, once all have come.
void read_png_rows(PngReading& reading) {
  Image& image = reading.stored.image;
  const std::size_t row_bytes = png_get_rowbytes(reading.png, reading.info);
  const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  const auto height = static_cast<std::size_t>(image.height);
  const std::size_t kept = reading.passes > 1 ? height : 1;
  const float scale = 1.0f / (reading.stored.bits == 8 ? 255.0f : 65535.0f);
  reading.rows.resize(kept * row_bytes);
  for (int pass = 0; pass < reading.passes; ++pass)
    for (std::size_t y = 0; y < height; ++y) {
      png_byte* bytes = reading.rows.data() + (y % kept) * row_bytes;
      png_read_row(reading.png, bytes, nullptr);
      if (pass + 1 < reading.passes) continue;
      image.pixels.resize((y + 1) * row);
      float* pixels = image.pixels.data() + y * row;
      for (std::size_t i = 0; i < row; ++i)
        pixels[i] =
            scale * static_cast<float>(reading.stored.bits == 8 ? bytes[i] : bytes[2 * i] << 8 | bytes[2 * i + 1]);
    }
}

void require_admitted(PngReading& reading) {
  const std::uint64_t width = png_get_image_width(reading.png, reading.info),
                      height = png_get_image_height(reading.png, reading.info);
  if (width * height > reading.most_pixels)
    throw std::runtime_error("a header that claims " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels, more than " + std::to_string(reading.most_pixels));
}

}  // namespace

std::optional<StoredPng> read_png(const BytesAt& bytes_at, std::uint64_t most_pixels) {
  if (says_more(bytes_at)) return std::nullopt;
  PngReading reading{bytes_at, most_pixels};
  reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, note_failure, ignore_remark);
  reading.info = reading.png ? png_create_info_struct(reading.png) : nullptr;
  if (!reading.info) throw std::runtime_error("a picture for which there is no memory");
  guard_png(reading, read_png_header);
  require_admitted(reading);
  keep_profile(reading);
  guard_png(reading, ask_for_channels);
  reading.stored.image.width = static_cast<int>(png_get_image_width(reading.png, reading.info));
  reading.stored.image.height = static_cast<int>(png_get_image_height(reading.png, reading.info));
  reading.stored.image.channels = png_get_channels(reading.png, reading.info);
  reading.stored.bits = png_get_bit_depth(reading.png, reading.info);
  guard_png(reading, read_png_rows);
  return std::move(reading.stored);
}

}  // namespace sturm
