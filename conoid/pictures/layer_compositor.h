#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "conoid/pictures/ellipse_kernel.h"
#include "io/images/image.h"

namespace sturm {

/// Keeps kernels and numbers of layers bounded; no image is that wide.
inline constexpr double largest_blur_radius_px = 16384.0;

/// Composites layers of spread light from near to far with clipped additive coverage: a layer of coverage α adds min(α,
/// 1 − A) to the coverage A so far; colour is divided by A at the end. Bands of rows run in parallel, each pixel is
/// summed by one thread in the order of the spots, in double: the same bits for any number of threads, and a bright
/// lamp does not swallow its dim neighbours (docs/theory.md#13-numerical-traps).
class LayerCompositor {
 public:
  /// Light from one point.
  struct Spot {
    static constexpr std::int32_t copied = -1;
    std::int32_t x, y;      ///< output pixel that holds it; may lie outside
    std::int32_t kernel;    ///< index among the layer's kernels, or `copied`: it stays in its pixel
    float coverage = 1.0f;  ///< how much of its own area it covers
    float rgb[3];
  };

  /// `spots_per_pixel`: as many spots of coverage 1 fill an output pixel.
  LayerCompositor(int width, int height, int spots_per_pixel);

  /// The next layer; rows of its spots ascend.
  void add_layer(std::span<const Spot> spots, std::span<const EllipseKernel> kernels);

  /// Radiance and coverage. A pixel that nothing covers is black.
  Image radiance() const;
  Image coverage() const;

 private:
  struct Light {
    double rgb[3] = {0.0, 0.0, 0.0};
    double coverage = 0.0;
    void add(const Light& other);
  };
  static Light weighted(const Spot& spot, double weight);
  void spread(const Spot& spot, std::span<const EllipseKernel> kernels, int row0, int row1);
  void composite(int row0, int row1);

  int width_, height_;
  double per_spot_;
  std::vector<Light> layer_, total_;
};

}  // namespace sturm
