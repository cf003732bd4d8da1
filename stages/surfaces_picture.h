#pragma once
#include <span>

#include "conoid/pictures/surface_pieces.h"
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// A sharp view with what it hides, wider than the picture by what the pupil sees beyond the picture's border.
struct SurfacesPicture {
  LayeredPicture picture;  ///< `jump_D` is set
  int margin_px = 0;       ///< on all four sides, in sharp pixels
};

/// Of the pieces that a view of width × height sharp pixels shows and hides. The nearest piece of a pixel is the
/// picture, the others are hidden. In the margin, pixels that the pupil does not see have no coverage. `jump_D`:
/// between two surfaces. Pieces farther out than the largest kernel reaches are left out.
SurfacesPicture surfaces_picture(std::vector<SurfacePiece> pieces, int width, int height, double jump_D);

/// The picture without its margin, each oversampling × oversampling pixels averaged.
Image without_margin(const Image& seen, int margin_px, int oversampling);

}  // namespace sturm
