#include "io/images/exr_reader.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTestFile.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "io/images/exr_attributes.h"
#include "io/images/exr_header.h"

namespace sturm {

namespace {

std::int64_t extent(int low, int high) {
  return std::int64_t{high} - low + 1;
}

/// In double: the product of the extents that a broken header claims can overflow 64 bits.
double pixels_of(const Imath::Box2i& window) {
  return static_cast<double>(extent(window.min.x, window.max.x)) *
         static_cast<double>(extent(window.min.y, window.max.y));
}

/// How many bytes of pixels one byte of a file can stand for, generously.
double largest_ratio(Imf::Compression compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return 1.0;
    case Imf::RLE_COMPRESSION:
      return 128.0;  // two bytes for a run of 128
    case Imf::ZIP_COMPRESSION:
    case Imf::ZIPS_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 1500.0;  // deflate's 1032, and 24 bits for 32
    case Imf::PIZ_COMPRESSION:
      return 512.0;  // a run of 256 half numbers in 10 bits
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
      return 16.0;  // three bytes for a block of 4 × 4 half numbers
    default:
      return 1e5;  // DWA: two numbers, deflated, for a block of 8 × 8
  }
}

/// Where `image` has values of a subsampled channel: at the first pixel of each block.
Imf::Slice blocks_of(Imf::Slice slice, const Imf::Channel& channel) {
  slice.xSampling = channel.xSampling;
  slice.ySampling = channel.ySampling;
  slice.xStride *= static_cast<std::size_t>(channel.xSampling);
  slice.yStride *= static_cast<std::size_t>(channel.ySampling);
  return slice;
}

/// The value of each block for all of its pixels. A data window starts with a whole block.
void fill_blocks(Image& image, int c, const Imf::Channel& channel) {
  if (channel.xSampling == 1 && channel.ySampling == 1) return;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.at(x, y)[c] = image.at(x - x % channel.xSampling, y - y % channel.ySampling)[c];
}

/// Rows that are read before there is room for the next ones: of about 64 MiB, but all lines that may be compressed
/// together.
int rows_at_once(std::size_t row_values) {
  constexpr std::size_t values = (std::size_t{1} << 26) / sizeof(float), rows_of_dwab = 256;
  return static_cast<int>(std::max(values / std::max(row_values, std::size_t{1}) / rows_of_dwab, std::size_t{1}) *
                          rows_of_dwab);
}

double stored_bytes(const Imf::Header& header) {
  double bytes_of_a_pixel = 0.0;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
    bytes_of_a_pixel += (c.channel().type == Imf::HALF ? 2.0 : 4.0) /
                        (static_cast<double>(c.channel().xSampling) * c.channel().ySampling);
  return bytes_of_a_pixel * pixels_of(header.dataWindow());
}

}  // namespace

Image in_display_window(Image stored, const Imf::Header& header) {
  const Imath::Box2i data = header.dataWindow(), display = header.displayWindow();
  if (data == display) return stored;
  Image image(static_cast<int>(extent(display.min.x, display.max.x)),
              static_cast<int>(extent(display.min.y, display.max.y)), stored.channels);
  const int left = std::max(data.min.x, display.min.x), right = std::min(data.max.x, display.max.x),
            top = std::max(data.min.y, display.min.y), bottom = std::min(data.max.y, display.max.y);
  if (left > right || top > bottom) throw std::runtime_error("no pixel inside of its display window");
  for (int y = top; y <= bottom; ++y) {
    const float* from = stored.at(left - data.min.x, y - data.min.y);
    std::copy_n(from, extent(left, right) * stored.channels, image.at(left - display.min.x, y - display.min.y));
  }
  return image;
}

ExrReader::ExrReader(const std::filesystem::path& path)
    : file_bytes_(static_cast<double>(std::filesystem::file_size(path))) {
  if (!Imf::isOpenExrFile(path.c_str())) throw std::runtime_error("another kind of file");
  require_honest_attributes(path);
  file_ = std::make_unique<Imf::MultiPartInputFile>(path.c_str());
}

bool ExrReader::is_deep(int part) const {
  return header(part).hasType() && Imf::isDeepData(header(part).type());
}

std::vector<std::string> ExrReader::channels(int part) const {
  std::vector<std::string> names;
  if (is_deep(part)) return names;
  const Imf::ChannelList& list = header(part).channels();
  for (auto c = list.begin(); c != list.end(); ++c) names.emplace_back(c.name());
  return names;
}

bool ExrReader::is_subsampled(int part, const std::string& name) const {
  const Imf::Channel& channel = header(part).channels()[name.c_str()];
  return channel.xSampling != 1 || channel.ySampling != 1;
}

bool ExrReader::has_channel(int part, const std::string& name) const {
  return header(part).channels().findChannel(name) != nullptr;
}

void ExrReader::require_room(int part, std::size_t channel_count, std::size_t max_bytes) const {
  const Imf::Header& h = header(part);
  const double pixels =
      pixels_of(h.dataWindow()) + (h.dataWindow() == h.displayWindow() ? 0.0 : pixels_of(h.displayWindow()));
  const double bytes = pixels * static_cast<double>(channel_count * sizeof(float));
  if (bytes > static_cast<double>(max_bytes))
    throw std::runtime_error("an image of " + std::to_string(bytes / (1 << 20)) + " MiB");
  if (stored_bytes(h) > largest_ratio(h.compression()) * file_bytes_)
    throw std::runtime_error("a header that claims more pixels than a file of this size can hold");
}

std::vector<Image> ExrReader::read(int part, const std::vector<std::vector<std::string>>& groups,
                                   std::size_t max_bytes) const {
  std::size_t channel_count = 0;
  for (const auto& group : groups) channel_count += group.size();
  require_room(part, channel_count, max_bytes);
  const Imath::Box2i data = header(part).dataWindow();
  const Imf::ChannelList& stored = header(part).channels();
  const auto width = static_cast<int>(extent(data.min.x, data.max.x));
  std::vector<Image> images;
  for (const auto& group : groups) {
    Image& image = images.emplace_back();
    image.width = width;
    image.height = static_cast<int>(extent(data.min.y, data.max.y));
    image.channels = static_cast<int>(group.size());
  }
  Imf::InputPart pixels(*file_, part);
  const int rows = rows_at_once(static_cast<std::size_t>(width) * channel_count);
  for (std::int64_t y = data.min.y; y <= data.max.y; y += rows) {
    const auto last = static_cast<int>(std::min<std::int64_t>(y + rows - 1, data.max.y));
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      Image& image = images[i];
      image.pixels.resize(static_cast<std::size_t>(extent(data.min.y, last)) * width * groups[i].size());
      for (std::size_t c = 0; c < groups[i].size(); ++c) {
        const Imf::Slice whole =
            exr_slice(image.pixels.data(), width, image.channels, static_cast<int>(c), data.min.x, data.min.y);
        frame.insert(groups[i][c], blocks_of(whole, stored[groups[i][c].c_str()]));
      }
    }
    pixels.setFrameBuffer(frame);
    pixels.readPixels(static_cast<int>(y), last);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t c = 0; c < groups[i].size(); ++c)
      fill_blocks(images[i], static_cast<int>(c), stored[groups[i][c].c_str()]);
    images[i] = in_display_window(std::move(images[i]), header(part));
  }
  return images;
}

}  // namespace sturm
