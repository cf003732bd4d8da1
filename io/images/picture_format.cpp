#include "io/images/picture_format.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/images/image_formats.h"

namespace sturm {

namespace {

using namespace std::string_view_literals;

/// 4096 × 4096: room for them is made at once, whatever the size of the file.
constexpr std::uint64_t pixels_for_nothing = std::uint64_t{1} << 24;

/// Of formats without a limit: an empty plane of WebP, HEIF or JPEG 2000 takes no bytes at all.
constexpr double without_limit = 1024.0;

struct Signature {
  std::size_t offset;
  std::string_view bytes;
  PictureFormat format;
};

constexpr std::array signatures = {
    Signature{0, "\x89PNG\r\n\x1a\n"sv, {"png", 8 * 1032.0}},  // deflate, of 1 bit
    Signature{0, "\xff\xd8\xff"sv, {"jpeg", 512.0}},           // progressive: a bit for a block of 8 × 8
    Signature{0, "II*\0"sv, {"tiff", std::nullopt}},
    Signature{0, "MM\0*"sv, {"tiff", std::nullopt}},
    Signature{0, "II+\0"sv, {"tiff", std::nullopt}},
    Signature{0, "MM\0+"sv, {"tiff", std::nullopt}},
    Signature{0, "BM"sv, {"bmp", 128.0}},       // run lengths: two bytes for 255
    Signature{0, "GIF87a"sv, {"gif", 2731.0}},  // LZW: 12 bits for 4096
    Signature{0, "GIF89a"sv, {"gif", 2731.0}},
    Signature{8, "WEBPVP8"sv, {"webp", without_limit}},
    Signature{4, "ftypavi"sv, {"heif", without_limit}},
    Signature{4, "ftyphe"sv, {"heif", without_limit}},
    Signature{4, "ftypmif1"sv, {"heif", without_limit}},
    Signature{4, "ftypmsf1"sv, {"heif", without_limit}},
    Signature{0, "\0\0\0\x0cjP  "sv, {"jpeg2000", without_limit}},
    Signature{0, "\xff\x4f\xff\x51"sv, {"jpeg2000", without_limit}},
    Signature{0, "8BPS"sv, {"psd", 512.0}},     // PackBits, of 1 bit
    Signature{0, "DDS "sv, {"dds", 2.0}},       // 8 bytes for a block of 4 × 4
    Signature{0, "\x01\xda"sv, {"sgi", 64.0}},  // two bytes for a run of 127
    Signature{0, "SIMPLE  ="sv, {"fits", 1.0}},
};

/// Portable any maps, "P1" to "P6"; a bit for a pixel.
bool is_portable_map(std::string_view start) {
  return start.size() > 2 && start[0] == 'P' && start[1] >= '1' && start[1] <= '6' &&
         " \t\r\n#"sv.find(start[2]) != std::string_view::npos;
}

/// A TGA file begins with no word of its own: what stands there must make sense.
bool may_be_targa(std::string_view start) {
  if (start.size() < 18) return false;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(start[i]); };
  constexpr std::array<unsigned char, 6> kinds = {1, 2, 3, 9, 10, 11};
  constexpr std::array<unsigned char, 5> bits = {8, 15, 16, 24, 32};
  const bool sized = (byte(12) | byte(13)) != 0 && (byte(14) | byte(15)) != 0;
  return byte(1) <= 1 && std::find(kinds.begin(), kinds.end(), byte(2)) != kinds.end() &&
         std::find(bits.begin(), bits.end(), byte(16)) != bits.end() && sized;
}

}  // namespace

std::optional<PictureFormat> picture_format(const BytesAt& bytes_at) {
  const std::string start = bytes_at(0, 18);
  for (const Signature& signature : signatures)
    if (start.size() >= signature.offset &&
        std::string_view(start).substr(signature.offset).starts_with(signature.bytes))
      return signature.format;
  if (is_portable_map(start)) return PictureFormat{"pnm", 8.0};
  if (may_be_targa(start)) return PictureFormat{"targa", 64.0};  // two bytes for a run of 128
  return std::nullopt;
}

std::uint64_t most_pixels_of(const PictureFormat& format, std::uint64_t size) {
  if (!format.pixels_per_byte) return most_pixels;
  const double possible = *format.pixels_per_byte * static_cast<double>(size);
  return static_cast<std::uint64_t>(
      std::clamp(possible, static_cast<double>(pixels_for_nothing), static_cast<double>(most_pixels)));
}

}  // namespace sturm
