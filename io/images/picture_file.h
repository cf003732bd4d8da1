#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "io/images/stated_colours.h"

namespace sturm {

/// What the numbers of a picture mean.
enum class PixelValues {
  Linear,  ///< light: twice the number is twice the radiance
  Display  ///< what a display is sent, 0 … 1: sRGB unless the file or somebody says otherwise
};

/// The picture in a file, as 3 channels, or 4 where it has alpha (the last one; grey ones have three equal channels).
struct PictureFile {
  /// The picture is the layer "": linear Rec. 709 (other primaries have been converted), or as stored for a display. Of
  /// an EXR also the layer "depth", if the file has distances of the picture's size, and the text attributes.
  LayeredImage picture;
  PixelValues values = PixelValues::Linear;  ///< what the numbers of the layer "" mean
  int bits = 0;                              ///< of integer values; 0 for floats
  StatedColours colours;                     ///< how they are decoded, if the values are for a display
  std::string layer;                         ///< of an EXR: the one that was taken, "" is the main one
  std::vector<std::string> notes;            ///< what was chosen, converted or left out on reading

  const Image& image() const { return picture.layers.at(""); }  ///< the picture without its further layers
};

/// Reads a picture: EXR, Radiance HDR, portable float map, and what OpenImageIO reads (PNG, JPEG, TIFF, …). The file's
/// first bytes decide, not its name. Floats are linear, integers are for a display.
///
/// `layer` names a layer of an EXR file (or a part of it; "" is its main one). Without it the main layer is taken, else
/// the only one with R, G and B, else the only one of luminance alone. Throws InputError where the file is missing,
/// broken or too large, where the choice is ambiguous (the message lists the layers), and for the layer of a file that
/// has none.
PictureFile read_picture_file(const std::filesystem::path& path,
                              const std::optional<std::string>& layer = std::nullopt);

/// The same of a PNG or JPEG file that stands in memory; `name` is for messages.
PictureFile read_embedded_picture(std::span<const unsigned char> bytes, const std::string& name);

/// Turns the picture into linear light: what is for a display is decoded as the file says. What is said and not
/// followed, and a curve that is not sRGB's, is added to the file's notes. `values` stays, as it tells where white
/// ends.
void make_linear(PictureFile& file);

/// Whether a file is an EXR, the one format with layers.
bool has_layers(const std::filesystem::path& path);

/// The first three channels.
Image without_alpha(const Image& image);

/// Throw InputError with file, pixel (x, y) from the upper left one (0, 0), value and channel, for the first value of
/// the first three channels that is not finite, and the second for negative ones, too. `advice` is added to what was
/// expected.
void require_finite_pixels(const Image& image, const std::string& file);
void require_light(const Image& image, const std::string& file, const std::string& advice = "");  ///< finite and ≥ 0

}  // namespace sturm
