#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "io/images/stated_colours.h"

namespace sturm {

/// Beyond them a picture is refused, whatever its format.
inline constexpr std::size_t most_pixels = std::size_t{1} << 28;

/// What was read of a picture.
struct StoredImage {
  Image image;                     ///< channels and values as in the file; integers as 0…1, alpha not multiplied in
  int bits = 0;                    ///< of integer values; 0 for floats
  bool was_cmyk = false;           ///< made of colours for printing
  StatedColours colours;           ///< how integers are decoded
  std::vector<std::string> notes;  ///< what was turned, left out or made on reading
};

/// Throws RuntimeFailure where the module that reads other pictures than PNG is not installed.
void require_image_formats();

/// Reads an image (see picture_format.h): a PNG with libpng, others, and a PNG that has EXIF or XMP data, with
/// OpenImageIO, which is loaded on first use. Values are not decoded (see
/// decoded_light). The picture is turned as its file says that it is to be seen (EXIF). Room is made for pixels that
/// are there, not for those that a header claims. Throws InputError for missing and broken files, those of other kinds
/// and claims that the bytes cannot fulfil, RuntimeFailure where the format module is not installed.
StoredImage read_stored_image(const std::filesystem::path& path);

/// Its pixels alone.
Image read_image(const std::filesystem::path& path);

/// The same of a file that stands in memory: a PNG or JPEG embedded in another file. `name` is for messages.
StoredImage read_embedded_image(std::span<const unsigned char> bytes, const std::string& name);

}  // namespace sturm
