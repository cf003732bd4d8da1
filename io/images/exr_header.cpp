#include "io/images/exr_header.h"

#include <OpenEXR/ImfStringAttribute.h>

#include <cstddef>
#include <set>
#include <stdexcept>

namespace sturm {

Imf::Slice exr_slice(float* pixels, int width, int channels, int channel, int left, int top) {
  const std::ptrdiff_t x_stride = std::ptrdiff_t{channels} * static_cast<std::ptrdiff_t>(sizeof(float)),
                       y_stride = x_stride * width;
  char* first = reinterpret_cast<char*>(pixels + channel);
  return Imf::Slice(Imf::FLOAT, first - left * x_stride - top * y_stride, static_cast<std::size_t>(x_stride),
                    static_cast<std::size_t>(y_stride));
}

void insert_metadata(Imf::Header& header, const std::map<std::string, std::string>& metadata) {
  static const std::set<std::string> with_meaning = {"name", "type", "version", "view", "chunkCount", "tiles"};
  for (const auto& [key, text] : metadata) {
    if (key.empty() || key.size() > 255 || with_meaning.contains(key) || header.find(key) != header.end())
      throw std::invalid_argument("\"" + key + "\" cannot be the name of an EXR text attribute");
    header.insert(key, Imf::StringAttribute(text));
  }
}

std::map<std::string, std::string> metadata_of(const Imf::Header& header) {
  static const std::set<std::string> of_the_part = {"name", "type"};
  std::map<std::string, std::string> metadata;
  for (auto a = header.begin(); a != header.end(); ++a)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute());
        text && !of_the_part.contains(a.name()))
      metadata[a.name()] = text->value();
  return metadata;
}

}  // namespace sturm
