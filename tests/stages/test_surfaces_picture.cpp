// The pieces of surfaces that a pupil sees, as a picture with hidden layers and a margin.
#include <gtest/gtest.h>

#include "stages/surfaces_picture.h"

namespace sturm {
namespace {

constexpr double jump_D = 0.3;

SurfacePiece piece(int x, int y, double vergence_D, float coverage, float light) {
  return {x, y, vergence_D, coverage, Eigen::Vector3f::Constant(light)};
}

/// Three pixels in a row: a wall that comes nearer to the right, and a card before a quarter of its middle.
std::vector<SurfacePiece> wall_and_card() {
  return {piece(0, 0, 1.0, 1.0f, 0.1f), piece(1, 0, 1.1, 1.0f, 0.2f), piece(1, 0, 2.0, 0.25f, 0.9f),
          piece(2, 0, 1.3, 1.0f, 0.3f)};
}

TEST(SurfacesPicture, TheNearestPieceIsThePictureAndTheOthersAreHidden) {
  const SurfacesPicture surfaces = surfaces_picture(wall_and_card(), 3, 1, jump_D);
  const LayeredPicture& picture = surfaces.picture;
  EXPECT_EQ(surfaces.margin_px, 0);
  EXPECT_EQ(picture.vergence_D, (std::vector<double>{1.0, 2.0, 1.3}));
  EXPECT_EQ(picture.coverage, (std::vector<float>{1.0f, 0.25f, 1.0f}));
  EXPECT_EQ(*picture.radiance.at(1, 0), 0.9f);
  EXPECT_EQ(picture.jump_D, jump_D);
  ASSERT_EQ(picture.hidden.size(), 1u);
  const HiddenPixel& hidden = picture.hidden[0];
  EXPECT_EQ(hidden.x, 1);
  EXPECT_EQ(hidden.y, 0);
  EXPECT_EQ(hidden.vergence_D, 1.1);
  EXPECT_EQ(hidden.coverage, 1.0f);
  EXPECT_EQ(hidden.rgb[1], 0.2f);
}

TEST(SurfacesPicture, AHiddenSurfaceHasTheSlopeOfItsOwnNeighbours) {
  const SurfacesPicture surfaces = surfaces_picture(wall_and_card(), 3, 1, jump_D);
  // (1.3 − 1.0)/2 to the right, nothing above or below.
  EXPECT_FLOAT_EQ(surfaces.picture.hidden.at(0).slope_x, 0.15f);
  EXPECT_EQ(surfaces.picture.hidden.at(0).slope_y, 0.0f);
  // The wall's end is 0.2 D from what is beside it: more than a jump of 0.15 D. One side is left.
  const SurfacesPicture broken = surfaces_picture(wall_and_card(), 3, 1, 0.15);
  EXPECT_FLOAT_EQ(broken.picture.hidden.at(0).slope_x, 0.1f);
}

TEST(SurfacesPicture, WhatLiesBeyondTheBorderStandsInAMargin) {
  std::vector<SurfacePiece> pieces = wall_and_card();
  pieces.push_back(piece(-2, 0, 0.9, 1.0f, 0.05f));
  const SurfacesPicture surfaces = surfaces_picture(pieces, 3, 1, jump_D);
  const LayeredPicture& picture = surfaces.picture;
  EXPECT_EQ(surfaces.margin_px, 2);
  ASSERT_EQ(picture.radiance.width, 7);
  ASSERT_EQ(picture.radiance.height, 5);
  const auto at = [](int x, int y) { return static_cast<std::size_t>(y * 7 + x); };
  EXPECT_EQ(picture.coverage[at(0, 2)], 1.0f);
  EXPECT_EQ(picture.vergence_D[at(0, 2)], 0.9);
  // Nothing is known of the others: no coverage, and no edge against the picture's border.
  EXPECT_EQ(picture.coverage[at(1, 2)], 0.0f);
  EXPECT_EQ(picture.vergence_D[at(1, 2)], 1.0);
  EXPECT_EQ(picture.vergence_D[at(6, 4)], 1.3);
  EXPECT_EQ(picture.coverage[at(3, 2)], 0.25f);
  EXPECT_EQ(picture.hidden.at(0).x, 3);
  EXPECT_EQ(picture.hidden.at(0).y, 2);
}

TEST(SurfacesPicture, TheMarginIsTakenOffAndSharpPixelsAreAveraged) {
  Image seen(6, 4, 1);
  for (int i = 0; i < 24; ++i) seen.pixels[static_cast<std::size_t>(i)] = static_cast<float>(i);
  const Image inner = without_margin(seen, 1, 2);
  ASSERT_EQ(inner.width, 2);
  ASSERT_EQ(inner.height, 1);
  EXPECT_FLOAT_EQ(*inner.at(0, 0), (7 + 8 + 13 + 14) / 4.0f);
  EXPECT_FLOAT_EQ(*inner.at(1, 0), (9 + 10 + 15 + 16) / 4.0f);
}

}  // namespace
}  // namespace sturm
