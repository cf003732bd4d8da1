#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// What blur that is wider than a pixel lacks where light is shared out among pixels; see layer_detail.h.
using Detail = std::array<float, 3>;

/// Bright light of a small part of the picture, which is spread from where it lies within its pixel.
struct LampPixel {
  std::int32_t x, y;     ///< pixel of the picture
  double vergence_D;     ///< 1/planar distance
  float rgb[3];          ///< its light, multiplied by the coverage, beyond what the picture or the hidden pixel has
  std::uint16_t places;  ///< bit 4 v + u: it lies in the column u and row v of the pixel's 4 × 4 places
};
inline constexpr std::uint16_t all_places = 0xffff;

/// A piece of a surface that the sharp picture does not show, because something nearer hides it.
struct HiddenPixel {
  std::int32_t x, y;                     ///< pixel of the picture
  double vergence_D;                     ///< 1/planar distance
  float coverage;                        ///< of the pixel, 0 … 1
  float rgb[3];                          ///< its colour, not multiplied by the coverage
  float slope_x = 0.0f, slope_y = 0.0f;  ///< of its surface: change of the vergence to the next pixel, right and down
  Detail detail{};
};

/// A sharp picture in linear light with the vergence of every pixel, and what it hides.
struct LayeredPicture {
  Image radiance;                   ///< 3 channels, finite, ≥ 0; not multiplied by the coverage
  std::vector<double> vergence_D;   ///< one for each pixel, row by row: of one surface, never a mean across an edge
  std::vector<float> coverage;      ///< by the picture's surface, 0 … 1; empty where it covers every pixel
  std::vector<HiddenPixel> hidden;  ///< rows ascend, columns within a row
  std::vector<LampPixel> lamps;     ///< the same order
  bool shows_detail = false;        ///< surfaces make up for what sharing light among pixels takes (layer_detail.h)
  /// Vergences of neighbours that differ by more belong to two surfaces.
  double jump_D = 0.0;
};

/// Pixels of a picture beside which another surface lies, ascending (io/images/depth_edges.h).
std::vector<std::size_t> edges_of(const LayeredPicture& picture);

/// Coverage from which on a surface leaves nothing of its pixel to others.
inline constexpr float covers_all = 0.999f;

/// A surface of its own, beside the picture: of the same size.
struct PictureLayer {
  Image radiance;  ///< 3 channels; not multiplied by the coverage
  std::vector<double> vergence_D;
  std::vector<float> coverage;  ///< empty where it covers every pixel
};

/// How the vergence of a surface changes from pixel to pixel at (x, y), to the right and down; neighbours beyond an
/// edge do not count.
struct SurfaceSlope {
  float x, y;
};
SurfaceSlope surface_slope(const std::vector<double>& vergence_D, int width, int height, int x, int y, double jump_D);

/// Whether a layer has a share of a pixel of a surface nearer than the picture's there, which is what its antialiased
/// edge has mixed into the pixel. (What covers the whole pixel would be the picture.)
bool lies_before(const PictureLayer& layer, const LayeredPicture& picture, std::size_t pixel);

/// What the picture does not show of the layers: what lies behind it, all of them where it does not cover its pixel,
/// and shares of pixels before it.
std::vector<HiddenPixel> hidden_by(const LayeredPicture& picture, std::span<const PictureLayer> layers);

}  // namespace sturm
