#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sturm {

/// What stands in a picture from byte `offset` on: `count` bytes, or as many as there are.
using BytesAt = std::function<std::string(std::uint64_t offset, std::size_t count)>;

/// One of the formats that OpenImageIO reads for this program.
struct PictureFormat {
  const char* reader;  ///< OpenImageIO's name of it
  /// How many pixels a byte of a file can stand for: of one-coloured pictures where the format has a limit, generously
  /// where it has none. None: the header must be read in full to tell, which the reader does.
  std::optional<double> pixels_per_byte;
};

/// The names of these formats, for messages.
inline constexpr const char* picture_formats =
    "a picture in PNG, JPEG, TIFF, TGA, BMP, GIF, WebP, HEIF or AVIF, JPEG 2000, PSD, DDS, SGI, PNM or FITS";

/// What the first bytes of a file say that it is; none for everything else. A name says nothing.
std::optional<PictureFormat> picture_format(const BytesAt& bytes_at);

/// How many pixels a file of this format with `size` bytes can stand for, but always as many as cost nothing.
std::uint64_t most_pixels_of(const PictureFormat& format, std::uint64_t size);

}  // namespace sturm
