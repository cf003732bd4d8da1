#include "io/images/claimed_size.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/images/big_endian.h"

namespace sturm {

namespace {

using namespace std::string_view_literals;

std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = count; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

/// Start of frame, of whatever kind: all markers from C0 to CF but for tables.
bool is_start_of_frame(unsigned marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

/// The frame comes after segments of any number and length, with stray bytes between them in some files.
std::optional<ClaimedSize> size_of_jpeg(const BytesAt& bytes_at) {
  constexpr unsigned start_of_scan = 0xDA, end_of_image = 0xD9;
  std::size_t stray_bytes = 4096;
  for (std::uint64_t at = 2;;) {
    const std::string segment = bytes_at(at, 9);
    if (segment.size() < 4) return std::nullopt;
    const auto marker = static_cast<unsigned>(big_endian(segment, 1, 1));
    if (segment[0] != '\xff' || marker == 0x00 || marker == 0xFF) {
      if (stray_bytes-- == 0) return std::nullopt;
      ++at;
      continue;
    }
    if (marker == start_of_scan || marker == end_of_image) return std::nullopt;
    if (is_start_of_frame(marker)) {
      if (segment.size() < 9) return std::nullopt;
      return ClaimedSize{big_endian(segment, 7, 2), big_endian(segment, 5, 2)};
    }
    const bool alone = marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8);  // without a length
    at += alone ? 2 : 2 + big_endian(segment, 2, 2);
  }
}

std::optional<ClaimedSize> size_of_bmp(const BytesAt& bytes_at) {
  const std::string start = bytes_at(14, 12);
  if (start.size() < 12) return std::nullopt;
  if (little_endian(start, 0, 4) == 12) return ClaimedSize{little_endian(start, 4, 2), little_endian(start, 6, 2)};
  const auto height = static_cast<std::int32_t>(little_endian(start, 8, 4));  // negative: the top row comes first
  return ClaimedSize{little_endian(start, 4, 4),
                     static_cast<std::uint64_t>(height < 0 ? -std::int64_t{height} : std::int64_t{height})};
}

std::optional<ClaimedSize> size_of_gif(const BytesAt& bytes_at) {
  const std::string screen = bytes_at(6, 4);
  if (screen.size() < 4) return std::nullopt;
  return ClaimedSize{little_endian(screen, 0, 2), little_endian(screen, 2, 2)};
}

/// Of its three kinds of first chunks: extended, lossless and lossy.
std::optional<ClaimedSize> size_of_webp(const BytesAt& bytes_at) {
  const std::string start = bytes_at(12, 18);
  if (start.size() < 18) return std::nullopt;
  if (start[3] == 'X') return ClaimedSize{1 + little_endian(start, 12, 3), 1 + little_endian(start, 15, 3)};
  constexpr std::uint64_t mask = (1 << 14) - 1;
  if (start[3] == 'L') {
    const std::uint64_t bits = little_endian(start, 9, 4);
    return ClaimedSize{1 + (bits & mask), 1 + (bits >> 14 & mask)};
  }
  return ClaimedSize{little_endian(start, 14, 2) & mask, little_endian(start, 16, 2) & mask};
}

/// The largest "ispe" property: pictures of this kind hold several, of tiles and previews too.
std::optional<ClaimedSize> size_of_heif(const BytesAt& bytes_at) {
  constexpr std::size_t where_boxes_are = 1 << 16;
  const std::string start = bytes_at(0, where_boxes_are);
  std::optional<ClaimedSize> largest;
  for (std::size_t at = start.find("ispe"); at != std::string::npos; at = start.find("ispe", at + 4)) {
    if (start.size() < at + 16) break;
    const ClaimedSize size{big_endian(start, at + 8, 4), big_endian(start, at + 12, 4)};
    if (!largest || size.width * size.height > largest->width * largest->height) largest = size;
  }
  return largest;
}

/// The segment SIZ of the code stream; the area minus what lies left of and above the picture.
std::optional<ClaimedSize> size_of_jpeg2000(const BytesAt& bytes_at) {
  constexpr std::size_t where_boxes_are = 1 << 16;
  const std::string start = bytes_at(0, where_boxes_are);
  const std::size_t at = start.find("\xff\x4f\xff\x51"sv);
  if (at == std::string::npos || start.size() < at + 24) return std::nullopt;
  return ClaimedSize{big_endian(start, at + 8, 4), big_endian(start, at + 12, 4)};
}

}  // namespace

std::optional<ClaimedSize> claimed_size(const PictureFormat& format, const BytesAt& bytes_at) {
  using SizeOf = std::optional<ClaimedSize> (*)(const BytesAt&);
  struct Header {
    std::string_view reader;
    SizeOf size;
  };
  static constexpr Header headers[] = {{"jpeg", size_of_jpeg}, {"bmp", size_of_bmp},   {"gif", size_of_gif},
                                       {"webp", size_of_webp}, {"heif", size_of_heif}, {"jpeg2000", size_of_jpeg2000}};
  const auto* header = std::find_if(std::begin(headers), std::end(headers),
                                    [&](const Header& known) { return known.reader == format.reader; });
  if (header == std::end(headers)) return std::nullopt;
  const std::optional<ClaimedSize> size = header->size(bytes_at);
  if (!size) throw std::runtime_error("a header that breaks off");
  return size;
}

}  // namespace sturm
