#include "io/images/exr_picture.h"

#include <OpenEXR/ImfEnvmapAttribute.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <stdexcept>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/plain_file.h"
#include "io/files/readable_text.h"
#include "io/images/colour_primaries.h"
#include "io/images/exr_channels.h"
#include "io/images/exr_header.h"
#include "io/images/exr_layers.h"

namespace sturm {

namespace {

constexpr std::size_t max_bytes = std::size_t{4} << 30;
constexpr const char* depth_layer = "depth";

/// Luminance and subsampled chroma by OpenEXR's own reader, which computes in half precision.
Image read_luminance_and_chroma(const std::filesystem::path& path, const ExrReader& file, const ExrLayer& layer) {
  if (file.parts() > 1) throw std::runtime_error("luminance and chroma in a file of several parts");
  file.require_room(layer.part, 2 * 4, max_bytes);  // once as half, once as float, and OpenEXR's own rows
  const std::string prefix = channel_layer(layer.channels.front());
  Imf::RgbaInputFile input(path.c_str(), prefix);
  const Imath::Box2i data = input.dataWindow();
  const int width = data.max.x - data.min.x + 1, height = data.max.y - data.min.y + 1;
  std::vector<Imf::Rgba> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  input.setFrameBuffer(pixels.data() - data.min.x - std::ptrdiff_t{data.min.y} * width, 1,
                       static_cast<std::size_t>(width));
  input.readPixels(data.min.y, data.max.y);
  Image image(width, height, 3);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    image.pixels[3 * i] = pixels[i].r;
    image.pixels[3 * i + 1] = pixels[i].g;
    image.pixels[3 * i + 2] = pixels[i].b;
  }
  return in_display_window(std::move(image), input.header());
}

Image with_three_channels(Image grey) {
  if (grey.channels != 1) return grey;
  Image colours(grey.width, grey.height, 3);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) colours.pixels[3 * i + c] = grey.pixels[i];
  return colours;
}

ColourPrimaries primaries_of(const Imf::Chromaticities& c) {
  const auto vector = [](const Imath::V2f& v) { return Eigen::Vector2d(v.x, v.y); };
  return {vector(c.red), vector(c.green), vector(c.blue), vector(c.white)};
}

/// Colours of other primaries become Rec. 709's; values without an attribute have them already.
void convert_colours(const Imf::Header& header, PictureFile& file) {
  if (!Imf::hasChromaticities(header)) return;
  const ColourPrimaries primaries = primaries_of(Imf::chromaticities(header));
  if (primaries.is_rec709()) return;
  try {
    transform_colours(file.picture.layers.at(""), rec709_from(primaries));
    file.notes.push_back("converted to Rec. 709 from the file's chromaticities: " + primaries.text());
  } catch (const std::domain_error& error) {
    file.notes.push_back(std::string("its chromaticities are ") + error.what() + ", so Rec. 709's are assumed");
  }
}

/// What a header says of the picture's shape, which nobody follows.
void note_shape(const Imf::Header& header, PictureFile& file) {
  if (const float ratio = header.pixelAspectRatio(); ratio != 1.0f)
    file.notes.push_back(formatted("its pixels are %.4g times as wide as high, which is not followed", ratio));
  if (Imf::hasEnvmap(header) && Imf::envmap(header) == Imf::ENVMAP_CUBE)
    file.notes.emplace_back("it is a cube map (envmap), which is not followed");
}

/// A depth layer beside the picture: where its surfaces are.
const ExrLayer* depth_beside(const std::vector<ExrLayer>& layers, const ExrLayer& picture) {
  const ExrLayer* depth = depth_layer_of(layers);
  return depth == &picture ? nullptr : depth;
}

/// The picture and the distances beside it; in another window than the picture's they belong to something else.
void read_picture_and_depth(const ExrReader& file, const ExrLayer& layer, const ExrLayer* depth, LayeredImage& read) {
  std::vector<std::vector<std::string>> groups = {layer.channels};
  if (depth && depth->part == layer.part) groups.push_back(depth->channels);
  std::vector<Image> images = file.read(layer.part, groups, max_bytes);
  if (depth && images.size() == 1) images.push_back(file.read(depth->part, {depth->channels}, max_bytes)[0]);
  if (depth && images[1].width == images[0].width && images[1].height == images[0].height)
    read.layers[depth_layer] = std::move(images[1]);
  read.layers[""] = with_three_channels(std::move(images[0]));
}

PictureFile read_layer(const std::filesystem::path& path, const ExrReader& file, const std::vector<ExrLayer>& layers,
                       const ExrLayer& layer) {
  PictureFile result;
  result.layer = layer.name;
  if (!layer.name.empty()) result.notes.push_back("layer \"" + readable(layer.name, 80) + "\"");
  if (layer.kind == ExrLayer::Kind::LuminanceAndChroma) {
    result.picture.layers[""] = read_luminance_and_chroma(path, file, layer);
    result.notes.emplace_back("stored as luminance and chroma, which OpenEXR decodes in half precision");
  } else {
    read_picture_and_depth(file, layer, depth_beside(layers, layer), result.picture);
    const auto is_subsampled = [&](const std::string& name) { return file.is_subsampled(layer.part, name); };
    if (std::any_of(layer.channels.begin(), layer.channels.end(), is_subsampled))
      result.notes.emplace_back("some channels have one value for each block of pixels, which all of them get");
    if (layer.kind == ExrLayer::Kind::Luminance) result.notes.emplace_back("luminance alone, shown as grey");
  }
  const Imf::Header& header = file.header(layer.part);
  if (layer.kind == ExrLayer::Kind::Colours || layer.kind == ExrLayer::Kind::LuminanceAndChroma)
    convert_colours(header, result);
  note_shape(header, result);
  result.picture.metadata = metadata_of(header);
  return result;
}

/// Opens a file and reads from its layers; whatever is wrong with it is an InputError.
template <class Read>
auto opened(const std::filesystem::path& path, const Read& read) {
  try {
    const ExrReader file(path);
    if (file.parts() == 1 && file.is_deep(0)) throw std::runtime_error("a deep EXR");
    return read(file, layers_of(file));
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(path.string(), "", error.what(),
                     "a complete EXR picture of at most " + std::to_string(max_bytes >> 20) + " MiB");
  }
}

}  // namespace

PictureFile read_exr_picture(const std::filesystem::path& path, const std::optional<std::string>& layer) {
  return opened(path, [&](const ExrReader& file, const std::vector<ExrLayer>& layers) {
    return read_layer(path, file, layers, chosen_layer(layers, layer, path.string()));
  });
}

Image read_exr_depth(const std::filesystem::path& path) {
  require_plain_file(path, "an EXR image");
  return opened(path, [&](const ExrReader& file, const std::vector<ExrLayer>& layers) {
    const ExrLayer* layer = depth_layer_of(layers);
    for (const ExrLayer& other : layers)
      if (!layer && (layers.size() == 1 || other.name.empty())) layer = &other;
    if (!layer)
      throw InputError(path.string(), "", "no channel Z", "a depth channel: Z, depth.Z, or a file of one channel");
    return file.read(layer->part, {layer->channels}, max_bytes)[0];
  });
}

}  // namespace sturm
