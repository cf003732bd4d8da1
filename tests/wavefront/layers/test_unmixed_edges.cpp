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

  /// `told`: the surface is among the layers, too.
  template <class Near>
  Edge(int from, int to, int mixed, float share, const Near& near, bool told = false) {
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
    if (told) add_surface(from, to, mixed, share, near);
    picture.hidden = hidden_by(picture, layers);
    unmix_edges(picture, layers);
  }

  template <class Near>
  void add_surface(int from, int to, int mixed, float share, const Near& near) {
    PictureLayer surface{Image(width, height, 3), std::vector<double>(width * height, near_D), {}};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        std::fill_n(surface.radiance.at(x, y), 3, near(x, y));
        surface.coverage.push_back(x == mixed ? share : x >= from && x < to ? 1.0f : 0.0f);
      }
    layers.push_back(std::move(surface));
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

TEST(UnmixedEdges, AreToldByTheLayerOfTheNearSurface) {
  // Colours that do not tell the coverage: it is that of the layer, and so is the colour.
  const auto noisy = [](int x, int y) { return (x * 7 + y * 13 + x * y) % 3 == 0 ? 0.75f : 0.4f; };
  const Edge far(0, 50, 50, 0.3f, noisy, true), near(0, 50, 49, 0.8f, noisy, true);
  for (int y = 0; y < height; ++y) {
    EXPECT_EQ(far.piece_before(50, y), 0.3f) << y;
    EXPECT_EQ(far.picture.radiance.at(50, y)[0], 0.5f) << y;
    EXPECT_EQ(far.coverage(49, y), 1.0f) << y;
    EXPECT_EQ(near.coverage(49, y), 0.8f) << y;
    EXPECT_EQ(near.picture.radiance.at(49, y)[0], noisy(49, y)) << y;
    EXPECT_EQ(near.piece_before(50, y), 0.0f) << y;
  }
}

TEST(UnmixedEdges, OfThreadsThatNoPixelsDepthShowsAreTold) {
  // It covers no pixel's middle, so the depth map shows the wall alone.
  const auto black = [](int, int) { return 0.0f; };
  const Edge thread(0, 0, 50, 0.4f, black, true);
  EXPECT_EQ(thread.piece_before(50, 10), 0.4f);
  EXPECT_EQ(thread.picture.radiance.at(50, 10)[0], 0.5f);
}

TEST(UnmixedEdges, WithoutALayerOfTheWallLeaveItsColour) {
  // 0.7 · 0.5 + 0.3 · 0.9 is the pixel; without the near surface's share the wall is 0.5 again.
  const auto plain = [](int, int) { return 0.9f; };
  Edge edge(0, 50, 50, 0.3f, plain);
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  picture.vergence_D.assign(width * height, far_D);
  picture.jump_D = 0.2;
  std::fill(picture.radiance.pixels.begin(), picture.radiance.pixels.end(), 0.5f);
  std::fill_n(picture.radiance.at(50, 10), 3, 0.62f);
  edge.layers.clear();
  edge.add_surface(0, 0, 50, 0.3f, plain);
  picture.hidden = hidden_by(picture, edge.layers);
  unmix_edges(picture, edge.layers);
  EXPECT_NEAR(picture.radiance.at(50, 10)[0], 0.5f, 1e-6);
}

TEST(UnmixedEdges, OfDarkBarsHoldTheLightOfTheirPixels) {
  // A black bar of which nobody knows how wide it is. What is taken apart makes the pixel again, so that a picture in
  // focus stays as it is; by the shape alone the bar would cover half of its pixel and be darker than black.
  const auto black = [](int, int) { return 0.0f; };
  const Edge bar(50, 51, 50, 0.9f, black);
  for (int y = 3; y < height - 3; ++y) {
    const float own = bar.picture.radiance.at(50, y)[0], covered = bar.coverage(50, y);
    EXPECT_NEAR(covered * own + (1.0f - covered) * 0.5f, 0.05f, 1e-5) << y;
  }
}

TEST(UnmixedEdges, PiecesOfSlantedSurfacesLeanAsTheyDo) {
  // A surface that comes nearer by 0.01 D with each column and 0.02 D with each row. Its piece in the next column lies
  // on it, and has its slope.
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  picture.jump_D = 0.2;
  PictureLayer wall{Image(width, height, 3), std::vector<double>(width * height, far_D), {}};
  std::fill(wall.radiance.pixels.begin(), wall.radiance.pixels.end(), 0.5f);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      picture.vergence_D.push_back(x < 50 ? near_D + 0.01 * x + 0.02 * y : far_D);
      std::fill_n(picture.radiance.at(x, y), 3, x < 50 ? 0.9f : x == 50 ? 0.62f : 0.5f);
    }
  picture.hidden = hidden_by(picture, {&wall, 1});
  unmix_edges(picture, {&wall, 1});
  int found = 0;
  for (const HiddenPixel& h : picture.hidden)
    if (h.x == 50 && h.vergence_D > 1.0) {
      EXPECT_NEAR(h.vergence_D, near_D + 0.5 + 0.02 * h.y, 1e-6);
      EXPECT_NEAR(h.slope_x, 0.01, 1e-6);
      EXPECT_NEAR(h.slope_y, 0.02, 1e-6);
      ++found;
    }
  EXPECT_EQ(found, height);
}

TEST(UnmixedEdges, HoldNoMoreLightThanTheirPixels) {
  // Beside a lamp of uneven brightness a pixel that has none of it, though it may have, by the lamp's shape.
  const Edge lamp(0, 50, 50, 0.0f, [](int x, int y) { return (x + y) % 2 == 0 ? 94.0f : 106.0f; });
  int pieces = 0;
  for (const HiddenPixel& h : lamp.picture.hidden)
    if (h.x == 50 && h.vergence_D == near_D) {
      EXPECT_GT(h.coverage, 0.01f);
      EXPECT_LE(h.coverage * h.rgb[0], 0.5f + 1e-5f);
      ++pieces;
    }
  EXPECT_EQ(pieces, height);
}

/// A near surface of grey 0.9 up to column 50 before a wall of `far`, of which the picture tells all that is known; the
/// mixed column holds `share` of the surface.
template <class Far>
LayeredPicture edge_in_a_picture(int mixed, float share, const Far& far) {
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  picture.jump_D = 0.2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float covered = x == mixed ? share : x < 50 ? 1.0f : 0.0f;
      picture.vergence_D.push_back(x < 50 ? near_D : far_D);
      std::fill_n(picture.radiance.at(x, y), 3, covered * 0.9f + (1.0f - covered) * far(x, y));
    }
  unmix_edges(picture, {});
  return picture;
}

TEST(UnmixedEdges, OfAPictureAloneHaveTheirCoverage) {
  const auto plain = [](int, int) { return 0.5f; };
  EXPECT_NEAR(edge_in_a_picture(49, 0.8f, plain).coverage[10 * width + 49], 0.8f, 1e-4);
  const LayeredPicture far = edge_in_a_picture(50, 0.3f, plain);
  ASSERT_EQ(far.hidden.size(), static_cast<std::size_t>(height));
  for (const HiddenPixel& piece : far.hidden) {
    EXPECT_EQ(piece.x, 50);
    EXPECT_EQ(piece.vergence_D, near_D);
    EXPECT_NEAR(piece.coverage, 0.3f, 1e-4);
    EXPECT_NEAR(piece.rgb[0], 0.9f, 1e-4);
    EXPECT_NEAR(far.radiance.at(50, piece.y)[0], 0.5f, 1e-4);
  }
}

TEST(UnmixedEdges, BeforeAFarSurfaceOfManyColoursStayWhereTheirDepthIs) {
  // Stripes as bright as the near surface, and black ones: no colour tells how much of a pixel the surface covers.
  const auto stripes = [](int x, int y) { return (x + y) % 2 == 0 ? 0.9f : 0.0f; };
  const LayeredPicture picture = edge_in_a_picture(-1, 0.0f, stripes);
  EXPECT_TRUE(picture.hidden.empty());
  for (const float coverage : picture.coverage) EXPECT_EQ(coverage, 1.0f);
}

TEST(UnmixedEdges, WhatNoMixtureExplainsStaysWhereItsDepthIs) {
  // The wall has a line of another colour right beside the surface, or the surface has one along its edge: brighter or
  // darker than both, so no share of either makes it.
  for (const float line : {0.0f, 2.0f}) {
    const LayeredPicture behind = edge_in_a_picture(-1, 0.0f, [&](int x, int) { return x == 50 ? line : 0.5f; });
    EXPECT_TRUE(behind.hidden.empty()) << line;
    for (int y = 0; y < height; ++y) EXPECT_EQ(behind.radiance.at(50, y)[0], line) << y;
    const LayeredPicture before = edge_in_a_picture(49, 0.0f, [&](int x, int) { return x == 49 ? line : 0.5f; });
    EXPECT_TRUE(before.hidden.empty()) << line;
    for (int y = 0; y < height; ++y) {
      EXPECT_EQ(before.radiance.at(49, y)[0], line) << y;
      EXPECT_EQ(before.coverage[static_cast<std::size_t>(y * width + 49)], 1.0f) << y;
    }
  }
}

/// Bars of many colours, two pixels wide, before a plain wall that only the picture tells; from right to left.
LayeredPicture bars_before_a_plain_wall(bool mirrored) {
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  picture.jump_D = 0.2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int u = mirrored ? width - 1 - x : x;
      const bool bar = u / 2 % 5 == 0;
      picture.vergence_D.push_back(bar ? near_D : far_D);
      std::fill_n(picture.radiance.at(x, y), 3,
                  bar ? 0.6f + 0.03f * static_cast<float>((7 * u * u + 13 * y + u * y) % 11) : 0.2f);
    }
  unmix_edges(picture, {});
  return picture;
}

TEST(UnmixedEdges, OfBarsBeforeAPlainWallAreThoseOfTheirMirrorImage) {
  // The wall's colours are summed up in another order, so that rounding gives them another variance.
  const LayeredPicture one = bars_before_a_plain_wall(false), other = bars_before_a_plain_wall(true);
  ASSERT_EQ(one.hidden.size(), other.hidden.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int mirrored = width - 1 - x;
      EXPECT_NEAR(one.coverage[static_cast<std::size_t>(y * width + x)],
                  other.coverage[static_cast<std::size_t>(y * width + mirrored)], 1e-4)
          << x << " " << y;
      EXPECT_NEAR(one.radiance.at(x, y)[0], other.radiance.at(mirrored, y)[0], 1e-4) << x << " " << y;
    }
}

}  // namespace
}  // namespace sturm
