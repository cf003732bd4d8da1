#include <gtest/gtest.h>

#include "wavefront/layers/unmixed_edges.h"

namespace sturm {
namespace {

constexpr int width = 100, height = 20;
constexpr double near_D = 2.0, far_D = 0.25;

/// A far wall of grey 0.5 that is known, and a surface before it from column `from` to `to`, whose colours are told by
/// `near`. The picture's columns beside the surface hold `share` of it.
struct Edge {
  LayeredPicture picture;
  std::vector<PictureLayer> layers{1};

  template <class Near>
  Edge(int from, int to, int mixed, float share, const Near& near) {
    picture.radiance = layers[0].radiance = Image(width, height, 3);
    std::fill(layers[0].radiance.pixels.begin(), layers[0].radiance.pixels.end(), 0.5f);
    layers[0].vergence_D.assign(width * height, far_D);
    picture.vergence_D.assign(width * height, far_D);
    picture.jump_D = 0.2;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const bool within = x >= from && x < to;
        const float covered = x == mixed ? share : within ? 1.0f : 0.0f;
        if (within) picture.vergence_D[static_cast<std::size_t>(y) * width + x] = near_D;
        std::fill_n(picture.radiance.at(x, y), 3, covered * near(x, y) + (1.0f - covered) * 0.5f);
      }
    picture.hidden = hidden_by(picture, layers);
    unmix_edges(picture, layers);
  }

  float coverage(int x, int y) const { return picture.coverage[static_cast<std::size_t>(y) * width + x]; }

  /// What a pixel of the wall holds of the surface before it.
  float piece_before(int x, int y) const {
    for (const HiddenPixel& h : picture.hidden)
      if (h.x == x && h.y == y && h.vergence_D == near_D) return h.coverage;
    return 0.0f;
  }
};

TEST(UnmixedEdges, OfPlainColoursHaveTheirCoverage) {
  const auto plain = [](int, int) { return 0.9f; };
  EXPECT_NEAR(Edge(0, 50, 50, 0.3f, plain).piece_before(50, 10), 0.3f, 1e-4);
  EXPECT_NEAR(Edge(0, 50, 49, 0.8f, plain).coverage(49, 10), 0.8f, 1e-4);
}

TEST(UnmixedEdges, OfANoisySurfaceAreThoseOfItsShape) {
  // The near surface is as bright as the wall on average, so colours do not tell how much of a pixel it covers. A
  // straight edge somewhere between the middles of two pixels covers a quarter of the one, and three quarters of the
  // other, give or take a quarter.
  const auto noisy = [](int x, int y) { return (x * 7 + y * 13 + x * y) % 3 == 0 ? 0.75f : 0.4f; };
  const Edge far(0, 50, 50, 0.3f, noisy), near(0, 50, 49, 0.8f, noisy);
  for (int y = 3; y < height - 3; ++y) {
    EXPECT_NEAR(far.piece_before(50, y), 0.3f, 0.26f) << y;
    EXPECT_NEAR(near.coverage(49, y), 0.8f, 0.26f) << y;
  }
}

TEST(UnmixedEdges, OfBarsWithoutAnUnmixedPixelAreThoseOfTheirShape) {
  const Edge bar(50, 52, 50, 0.7f, [](int, int) { return 0.9f; });
  for (int y = 3; y < height - 3; ++y) EXPECT_NEAR(bar.coverage(50, y), 0.75f, 1e-3) << y;
}

}  // namespace
}  // namespace sturm
