#pragma once
#include "io/images/image.h"

namespace sturm {

/// The picture as it is to be seen, from rows and columns as they are stored. `orientation` is that of EXIF and TIFF: 2
/// to 4 mirror and turn, 5 to 8 also swap width and height; 1 and numbers that do not exist mean as it is.
Image upright(Image stored, int orientation);

}  // namespace sturm
