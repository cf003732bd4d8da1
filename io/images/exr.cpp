#include "io/images/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfOutputFile.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/images/exr_channels.h"
#include "io/images/exr_header.h"
#include "io/images/exr_output.h"
#include "io/images/exr_reader.h"

namespace sturm {

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
  write_exr_file(path, [&](Imf::OStream& stream) {
    Imf::OutputFile output(stream, header);
    output.setFrameBuffer(frame);
    output.writePixels(height);
  });
}

LayeredImage read_exr(const std::filesystem::path& path, std::size_t max_bytes) {
  require_plain_file(path, "an EXR image");
  try {
    const ExrReader file(path);
    if (file.parts() > 1) throw std::runtime_error("a multi-part EXR");
    if (file.is_deep(0)) throw std::runtime_error("a deep EXR");
    const auto layers = layers_of_channels(file.channels(0));
    std::vector<std::vector<std::string>> groups;
    for (const auto& [layer, channels] : layers) groups.push_back(channels);
    std::vector<Image> images = file.read(0, groups, max_bytes);
    LayeredImage image;
    auto next = images.begin();
    for (const auto& [layer, channels] : layers) image.layers[layer] = std::move(*next++);
    image.metadata = metadata_of(file.header(0));
    return image;
  } catch (const std::exception& error) {
    throw InputError(path.string(), "", error.what(),
                     "a complete single-part EXR, of at most " + std::to_string(max_bytes >> 20) + " MiB");
  }
}

}  // namespace sturm
