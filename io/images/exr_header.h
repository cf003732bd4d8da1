#pragma once
// Used by the EXR writers and readers only: it brings OpenEXR's headers with it.
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>

#include <map>
#include <string>

namespace sturm {

/// The slice of one channel of an interleaved float image whose first pixel is at (left, top) in EXR coordinates.
Imf::Slice exr_slice(float* pixels, int width, int channels, int channel, int left = 0, int top = 0);

/// Throws std::invalid_argument for keys that have a meaning of their own in the format.
void insert_metadata(Imf::Header& header, const std::map<std::string, std::string>& metadata);

/// All text attributes.
std::map<std::string, std::string> metadata_of(const Imf::Header& header);

}  // namespace sturm
