#include "io/images/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTestFile.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/images/exr_channels.h"
#include "io/images/exr_header.h"

namespace sturm {

namespace {

std::int64_t extent(int low, int high) {
  return std::int64_t{high} - low + 1;
}

/// The part of `stored` (first pixel at `data`'s corner) that lies in the window `display`; 0 elsewhere.
Image in_window(const Image& stored, const Imath::Box2i& data, const Imath::Box2i& display) {
  Image image(static_cast<int>(extent(display.min.x, display.max.x)),
              static_cast<int>(extent(display.min.y, display.max.y)), stored.channels);
  const int left = std::max(data.min.x, display.min.x), right = std::min(data.max.x, display.max.x);
  for (int y = std::max(data.min.y, display.min.y); y <= std::min(data.max.y, display.max.y) && left <= right; ++y) {
    const float* from = stored.at(left - data.min.x, y - data.min.y);
    std::copy_n(from, (extent(left, right)) * stored.channels, image.at(left - display.min.x, y - display.min.y));
  }
  return image;
}

LayeredImage read_pixels(Imf::InputFile& file, std::size_t max_bytes) {
  const Imf::Header& header = file.header();
  const Imath::Box2i data = header.dataWindow(), display = header.displayWindow();
  std::vector<std::string> channels;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (c.channel().type == Imf::UINT) throw std::runtime_error(std::string("integer channel ") + c.name());
    if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
      throw std::runtime_error(std::string("subsampled channel ") + c.name());
    channels.emplace_back(c.name());
  }
  // In double: the product of the extents that a broken header claims can overflow 64 bits.
  const double pixels =
      static_cast<double>(extent(data.min.x, data.max.x)) * static_cast<double>(extent(data.min.y, data.max.y)) +
      (data == display ? 0.0
                       : static_cast<double>(extent(display.min.x, display.max.x)) *
                             static_cast<double>(extent(display.min.y, display.max.y)));
  const double bytes = pixels * static_cast<double>(channels.size() * sizeof(float));
  if (bytes > static_cast<double>(max_bytes))
    throw std::runtime_error("an image of " + std::to_string(bytes / (1 << 20)) + " MiB");

  LayeredImage image;
  Imf::FrameBuffer frame;
  for (const auto& [layer, names] : layers_of_channels(channels)) {
    Image& pixels_of_layer = image.layers[layer] =
        Image(static_cast<int>(extent(data.min.x, data.max.x)), static_cast<int>(extent(data.min.y, data.max.y)),
              static_cast<int>(names.size()));
    for (std::size_t c = 0; c < names.size(); ++c)
      frame.insert(names[c], exr_slice(pixels_of_layer.pixels.data(), pixels_of_layer.width, pixels_of_layer.channels,
                                       static_cast<int>(c), data.min.x, data.min.y));
  }
  file.setFrameBuffer(frame);
  file.readPixels(data.min.y, data.max.y);
  if (data != display)
    for (auto& [layer, stored] : image.layers) stored = in_window(stored, data, display);
  image.metadata = metadata_of(header);
  return image;
}

}  // namespace

void write_exr(const std::filesystem::path& path, const LayeredImage& image) {
  if (image.layers.empty()) throw std::invalid_argument("an EXR needs at least one layer");
  const int width = image.layers.begin()->second.width, height = image.layers.begin()->second.height;
  if (width < 1 || height < 1) throw std::invalid_argument("an EXR needs at least one pixel");
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  for (const auto& [layer, pixels] : image.layers) {
    const std::vector<std::string> names = exr_channel_names(layer, pixels.channels);
    if (names.empty() || pixels.width != width || pixels.height != height)
      throw std::invalid_argument("layer \"" + layer + "\" does not fit into the EXR: " + std::to_string(pixels.width) +
                                  " x " + std::to_string(pixels.height) + ", " + std::to_string(pixels.channels) +
                                  " channels");
    for (std::size_t c = 0; c < names.size(); ++c) {
      if (header.channels().findChannel(names[c]))
        throw std::invalid_argument("two layers have the channel " + names[c]);
      header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
      // OpenEXR only reads through the slices of an output file.
      frame.insert(names[c],
                   exr_slice(const_cast<float*>(pixels.pixels.data()), width, pixels.channels, static_cast<int>(c)));
    }
  }
  insert_metadata(header, image.metadata);
  AtomicFile file(path);
  try {
    Imf::OutputFile output(file.temporary().c_str(), header);
    output.setFrameBuffer(frame);
    output.writePixels(height);
  } catch (const std::exception& error) {
    throw RuntimeFailure(path.string() + ": writing failed: " + error.what());
  }
  file.commit();
}

LayeredImage read_exr(const std::filesystem::path& path, std::size_t max_bytes) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code))
    throw InputError(path.string(), "", "no such file", "an EXR image");
  try {
    bool tiled = false, deep = false, multi_part = false;
    if (!Imf::isOpenExrFile(path.c_str(), tiled, deep, multi_part)) throw std::runtime_error("another kind of file");
    if (deep || multi_part) throw std::runtime_error(deep ? "a deep EXR" : "a multi-part EXR");
    Imf::InputFile file(path.c_str());
    return read_pixels(file, max_bytes);
  } catch (const std::exception& error) {
    throw InputError(
        path.string(), "", error.what(),
        "a complete single-part EXR of half or float channels, of at most " + std::to_string(max_bytes >> 20) + " MiB");
  }
}

}  // namespace sturm
