#pragma once
#include <cstdint>
#include <vector>

#include "conoid/pictures/multipass.h"
#include "conoid/pictures/sight_field.h"
#include "io/images/fragment_image.h"

namespace sturm {

/// A piece of a surface that some point of the pupil sees, in one sharp pixel.
struct SurfacePiece {
  std::int32_t x, y;  ///< sharp pixel; outside of the view beyond the border
  double vergence_D;  ///< 1/t along the chief ray of the pixel's middle; 0 for the surroundings
  float coverage;     ///< of the pixel, as if nothing stood before it
  Eigen::Vector3f radiance;
  const Fragment* part = nullptr;  ///< where in its pixel it is, beside the rim of a lamp
};

/// The vergences of two pieces of a pixel that differ by more blur differently, by one sharp pixel [D]; infinite for a
/// pinhole.
double sheet_thickness_D(int oversampling, const SightField& field);

/// All pieces that a sharp view and `unseen` hold, pixel by pixel, row by row, then those of `unseen`; nearest first in
/// each pixel of either. Pieces of a pixel at about the same depth (sheet_thickness_D) share it; what lies behind them
/// goes on there. `view` covers the picture of `field` and outlives the result.
std::vector<SurfacePiece> surface_pieces(const FragmentImage& view, int oversampling, const SightField& field,
                                         const std::vector<UnseenPiece>& unseen);

}  // namespace sturm
