#include "io/images/picture_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/plain_file.h"
#include "io/files/text_file.h"
#include "io/images/exr_picture.h"
#include "io/images/image_formats.h"
#include "io/images/portable_float_map.h"
#include "io/images/radiance_hdr.h"

namespace sturm {

namespace {

constexpr std::string_view exr_magic("\x76\x2f\x31\x01", 4);

std::string first_bytes(const std::filesystem::path& path) {
  std::array<char, 16> bytes{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(stream.gcount())};
}

/// Three channels, or four where the last one is alpha.
Image as_colours(Image stored, std::vector<std::string>& notes) {
  const int channels = stored.channels;
  if (channels == 3 || channels == 4) return stored;
  const bool grey = channels <= 2, alpha = channels == 2;
  if (!grey) notes.push_back("the first three of its " + std::to_string(channels) + " channels are taken");
  Image colours(stored.width, stored.height, alpha ? 4 : 3);
  for (int y = 0; y < stored.height; ++y)
    for (int x = 0; x < stored.width; ++x) {
      const float* from = stored.at(x, y);
      float* to = colours.at(x, y);
      for (int c = 0; c < 3; ++c) to[c] = from[grey ? 0 : c];
      if (alpha) to[3] = from[1];
    }
  return colours;
}

PictureFile linear_picture(Image image, std::vector<std::string> notes) {
  PictureFile file;
  file.notes = std::move(notes);
  file.picture.layers[""] = as_colours(std::move(image), file.notes);
  return file;
}

/// What OpenImageIO has read: integers are for a display.
PictureFile stored_picture(StoredImage stored) {
  PictureFile file = linear_picture(std::move(stored.image), std::move(stored.notes));
  file.bits = stored.bits;
  file.colours = std::move(stored.colours);
  file.values = stored.bits > 0 ? PixelValues::Display : PixelValues::Linear;
  return file;
}

PictureFile read_radiance_hdr(const std::string& bytes) {
  RadianceHdr hdr = decode_radiance_hdr(bytes, most_pixels);
  if (hdr.primaries && !hdr.primaries->is_rec709()) {
    transform_colours(hdr.image, rec709_from(*hdr.primaries));
    hdr.notes.push_back("converted to Rec. 709 from the file's PRIMARIES: " + hdr.primaries->text());
  }
  return linear_picture(std::move(hdr.image), std::move(hdr.notes));
}

/// Formats that this program reads itself from the bytes in memory.
template <class Decode>
PictureFile decoded(const std::filesystem::path& path, const char* format, const Decode& decode) {
  try {
    const std::optional<std::string> bytes = file_contents(path);
    if (!bytes) throw std::runtime_error("a file that cannot be read");
    return decode(*bytes);
  } catch (const std::exception& error) {
    throw InputError(path.string(), "", error.what(), std::string("a complete ") + format + " picture");
  }
}

template <class Fits>
void require_pixels(const Image& image, const std::string& file, const std::string& expected, const Fits& fits) {
  constexpr std::array names = {"R", "G", "B"};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < std::min(image.channels, 3); ++c)
        if (const float value = image.at(x, y)[c]; !fits(value))
          throw InputError(file, "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ")",
                           exact_number(value) + " in " + names[static_cast<std::size_t>(c)], expected);
}

}  // namespace

bool has_layers(const std::filesystem::path& path) {
  return first_bytes(path).starts_with(exr_magic);
}

PictureFile read_picture_file(const std::filesystem::path& path, const std::optional<std::string>& layer) {
  require_plain_file(path, "a picture");
  const std::string start = first_bytes(path);
  if (start.starts_with(exr_magic)) return read_exr_picture(path, layer);
  if (layer)
    throw InputError(path.string(), "", "a file without layers", "an EXR file with a layer \"" + *layer + "\"");
  if (is_radiance_hdr(start)) return decoded(path, "Radiance", read_radiance_hdr);
  if (is_portable_float_map(start))
    return decoded(path, "PFM", [](const std::string& bytes) {
      return linear_picture(decode_portable_float_map(bytes, most_pixels), {});
    });
  return stored_picture(read_stored_image(path));
}

PictureFile read_embedded_picture(std::span<const unsigned char> bytes, const std::string& name) {
  return stored_picture(read_embedded_image(bytes, name));
}

void make_linear(PictureFile& file) {
  file.notes.insert(file.notes.end(), file.colours.notes.begin(), file.colours.notes.end());
  if (file.values == PixelValues::Linear) return;
  if (const auto& gamma = file.colours.gamma)
    file.notes.push_back(formatted("light is its numbers to the power of %.4g, as the file states", *gamma));
  Image& image = file.picture.layers.at("");
  image = decoded_light(image, file.colours);
}

Image without_alpha(const Image& image) {
  if (image.channels == 3) return image;
  Image colours(image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(image.at(x, y), 3, colours.at(x, y));
  return colours;
}

void require_finite_pixels(const Image& image, const std::string& file) {
  require_pixels(image, file, "finite pixels", [](float value) { return std::isfinite(value); });
}

void require_light(const Image& image, const std::string& file, const std::string& advice) {
  require_pixels(image, file, "finite values of at least 0" + advice,
                 [](float value) { return value >= 0.0f && std::isfinite(value); });
}

}  // namespace sturm
