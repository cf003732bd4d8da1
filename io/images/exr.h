#pragma once
#include <cstddef>
#include <filesystem>

#include "io/images/image.h"

namespace sturm {

/// Writes all layers into one single-part EXR: float32 channels named as LayeredImage says, ZIP compression, metadata
/// as string attributes. The same image gives the same bytes. Written to a temporary name first. Throws RuntimeFailure
/// if it cannot be written, std::invalid_argument if layers differ in size, are empty, or a name or channel count has
/// no place in the format.
void write_exr(const std::filesystem::path& path, const LayeredImage& image);

/// Reads all layers of a single-part EXR of half, float or integer channels (scan lines or tiles) as they are; deep and
/// multi-part files are refused, subsampled channels left out. Channels that do not form a known group become 1-channel
/// layers of their full name. Pixels of the display window that the file does not store are 0. Throws InputError for
/// missing, broken and foreign files and for those that claim to need more than `max_bytes` of memory (checked before
/// any pixel is allocated). A picture of whatever program is read by read_picture_file (io/images/picture_file.h).
LayeredImage read_exr(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{4} << 30);

}  // namespace sturm
