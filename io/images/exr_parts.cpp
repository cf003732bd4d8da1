#include "io/images/exr_parts.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>

#include <stdexcept>

#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/images/exr_header.h"
#include "io/images/exr_output.h"

namespace sturm {

namespace {

/// All parts of a file share one display window, which says nothing here: the smallest that holds them all.
Imath::Box2i display_window(const std::vector<ExrPart>& parts) {
  Imath::Box2i window({0, 0}, {0, 0});
  for (const ExrPart& part : parts) window.extendBy(Imath::V2i(part.image.width - 1, part.image.height - 1));
  return window;
}

Imf::Header header_of(const ExrPart& part, const Imath::Box2i& display) {
  const Image& image = part.image;
  if (image.width < 1 || image.height < 1 || part.channels.size() != static_cast<std::size_t>(image.channels))
    throw std::invalid_argument("part \"" + part.name + "\" is empty or has not one name for each channel");
  Imf::Header header(display, Imath::Box2i({0, 0}, {image.width - 1, image.height - 1}));
  header.setName(part.name);
  header.setType(Imf::SCANLINEIMAGE);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const std::string& channel : part.channels) {
    if (header.channels().findChannel(channel))
      throw std::invalid_argument("part \"" + part.name + "\" has two channels " + channel);
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  }
  insert_metadata(header, part.metadata);
  return header;
}

Imf::FrameBuffer frame_of(const ExrPart& part, float* pixels) {
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < part.channels.size(); ++c)
    frame.insert(part.channels[c], exr_slice(pixels, part.image.width, part.image.channels, static_cast<int>(c)));
  return frame;
}

/// The part of a header without its pixels.
ExrPart described(const Imf::Header& header) {
  ExrPart part;
  part.name = header.hasName() ? header.name() : "";
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (c.channel().type == Imf::UINT || c.channel().xSampling != 1 || c.channel().ySampling != 1)
      throw std::runtime_error(std::string("an integer or subsampled channel ") + c.name());
    part.channels.emplace_back(c.name());
  }
  if (header.hasType() && header.type() != Imf::SCANLINEIMAGE)
    throw std::runtime_error("a part of type " + header.type());
  const Imath::Box2i window = header.dataWindow();
  if (window.min.x != 0 || window.min.y != 0) throw std::runtime_error("a part whose window does not start at 0");
  part.image.width = window.max.x + 1;
  part.image.height = window.max.y + 1;
  part.image.channels = static_cast<int>(part.channels.size());
  part.metadata = metadata_of(header);
  return part;
}

double bytes_of(const Image& image) {
  return static_cast<double>(image.width) * image.height * image.channels * sizeof(float);
}

}  // namespace

void write_exr_parts(const std::filesystem::path& path, const std::vector<ExrPart>& parts) {
  if (parts.empty()) throw std::invalid_argument("an EXR needs at least one part");
  std::vector<Imf::Header> headers;
  for (const ExrPart& part : parts) headers.push_back(header_of(part, display_window(parts)));
  write_exr_file(path, [&](Imf::OStream& stream) {
    Imf::MultiPartOutputFile output(stream, headers.data(), static_cast<int>(headers.size()));
    for (std::size_t p = 0; p < parts.size(); ++p) {
      Imf::OutputPart out(output, static_cast<int>(p));
      // OpenEXR only reads through the slices of an output file.
      out.setFrameBuffer(frame_of(parts[p], const_cast<float*>(parts[p].image.pixels.data())));
      out.writePixels(parts[p].image.height);
    }
  });
}

std::vector<ExrPart> read_exr_parts(const std::filesystem::path& path, std::size_t max_bytes) {
  require_plain_file(path, "an EXR file");
  try {
    Imf::MultiPartInputFile file(path.c_str());
    std::vector<ExrPart> parts;
    double bytes = 0.0;
    for (int p = 0; p < file.parts(); ++p) {
      parts.push_back(described(file.header(p)));
      bytes += bytes_of(parts.back().image);  // before anything is allocated
    }
    if (bytes > static_cast<double>(max_bytes))
      throw std::runtime_error("images of " + std::to_string(bytes / (1 << 20)) + " MiB");
    for (int p = 0; p < file.parts(); ++p) {
      ExrPart& part = parts[static_cast<std::size_t>(p)];
      part.image = Image(part.image.width, part.image.height, part.image.channels);
      Imf::InputPart in(file, p);
      in.setFrameBuffer(frame_of(part, part.image.pixels.data()));
      in.readPixels(0, part.image.height - 1);
    }
    return parts;
  } catch (const std::exception& error) {
    throw InputError(path.string(), "", error.what(),
                     "a complete EXR of float scan-line parts, of at most " + std::to_string(max_bytes >> 20) + " MiB");
  }
}

}  // namespace sturm
