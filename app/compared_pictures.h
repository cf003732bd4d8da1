#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "io/images/picture_file.h"

namespace sturm {

/// The pictures of `sturm compare`, in linear light, 3 channels each, of one size, with finite pixels.
struct ComparedPictures {
  PictureFile test, reference;
  std::vector<Image> seeds;        ///< of `noise`
  std::vector<std::string> notes;  ///< "FILE: what was chosen, decoded or left out"
};

/// Reads them. What a display was sent is decoded (sRGB) and divided by the exposure, so that the display space of the
/// metrics holds the stored values. Throws InputError with the file's name.
ComparedPictures read_compared_pictures(const CompareOptions& options);

}  // namespace sturm
