#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// One part of a multi-part EXR file: an image whose channels have names of their own.
struct ExrPart {
  std::string name;                   ///< unique in its file
  std::vector<std::string> channels;  ///< one name for each channel of `image`, in any order
  Image image;
  std::map<std::string, std::string> metadata;  ///< text attributes
};

/// Writes the parts into one file: float32 channels, ZIP compression. The same parts give the same bytes. Written to a
/// temporary name first. Throws RuntimeFailure if it cannot be written, std::invalid_argument for parts that the format
/// has no place for.
void write_exr_parts(const std::filesystem::path& path, const std::vector<ExrPart>& parts);

/// Reads a file of write_exr_parts: every part with all its channels (in the order of their names) and text attributes.
/// Throws InputError for missing, broken and foreign files and for those that claim to need more than `max_bytes`.
std::vector<ExrPart> read_exr_parts(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{4} << 30);

}  // namespace sturm
