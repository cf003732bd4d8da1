#pragma once
// Used by the EXR readers only: it brings OpenEXR's headers with it.
#include <OpenEXR/ImfMultiPartInputFile.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// An opened EXR file of one part or several. What is wrong with the file is thrown as std::runtime_error, to be named
/// by the caller.
class ExrReader {
 public:
  explicit ExrReader(const std::filesystem::path& path);

  int parts() const { return file_->parts(); }
  const Imf::Header& header(int part) const { return file_->header(part); }
  bool is_deep(int part) const;

  /// The channels of a part; none of a deep part.
  std::vector<std::string> channels(int part) const;

  /// Whether a part has a channel, subsampled or not.
  bool has_channel(int part, const std::string& name) const;

  /// Whether a channel of a part has one value for a block of several pixels.
  bool is_subsampled(int part, const std::string& name) const;

  /// One image for each group of channels of a part, as floats, in the display window; pixels that the file does not
  /// store are 0, and those of a block have its value. More than `max_bytes` of memory, and more pixels than a file of
  /// this size can hold, are refused before anything is allocated.
  std::vector<Image> read(int part, const std::vector<std::vector<std::string>>& groups, std::size_t max_bytes) const;

  /// Throws where images of `channels` floats for each pixel of a part are refused.
  void require_room(int part, std::size_t channels, std::size_t max_bytes) const;

 private:
  double file_bytes_;
  std::unique_ptr<Imf::MultiPartInputFile> file_;
};

/// The part of `stored` (first pixel at the corner of the header's data window) that lies in its display window; 0
/// elsewhere. Throws std::runtime_error where none does.
Image in_display_window(Image stored, const Imf::Header& header);

}  // namespace sturm
