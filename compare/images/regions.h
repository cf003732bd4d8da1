#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "lensmodel/eye.h"

namespace sturm {

/// A part of a picture with a name.
struct Region {
  std::string name;  ///< one of those of regions_of
  Image mask;        ///< one channel, 1 inside and 0 outside

  std::size_t pixels() const;  ///< inside of the mask
};

/// What regions are told from. Each layer has one channel and the size of the pictures.
struct RegionLayers {
  std::optional<Image> depth;    ///< [m], +∞ where nothing was hit
  std::optional<Image> blur_px;  ///< larger semi-axis of the blur ellipse [px]
};

/// The larger semi-axis a·σ₁(I/d + F − A·I) of the naked eye's blur ellipse at each pixel [px], for one gaze and one
/// accommodation A [D] over the whole picture (docs/theory.md#4-the-footprint-of-the-pupil). `depth` is measured along
/// the line of sight; `pixel_slope` is the width of a pixel as a slope.
Image blur_semi_axis_px(const Image& depth, const Eye& eye, double accommodation_D, double pixel_slope);

/// Where one thing hides another. The reciprocal of a plane's depth is affine in the picture, so its second difference
/// along a row or a column vanishes on planes however steep, and stays below 5 % of the larger 1/depth on smooth
/// surfaces; above it is an edge. The mask grows around each edge pixel by 2 px and its blur (at most 32 px), as far as
/// the hidden and the hiding surface mix. 1 inside.
Image occlusion_edges(const Image& depth, const Image* blur_px);

/// Regions of a pair of pictures in linear light:
/// - `in_focus`: blur semi-axis at most 1 px; `blurred`: above (both need the blur layer);
/// - `occlusion_edges`: see above (needs depth);
/// - `highlights`: exposure · luma above 1 in either picture, which display space cuts off.
/// What the layers do not tell is left out; regions may overlap and may be empty. Throws InputError for layers of
/// another size.
std::vector<Region> regions_of(const Image& test, const Image& reference, double exposure, const RegionLayers& layers);

}  // namespace sturm
