#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/images/disocclusion.h"

namespace sturm {
namespace {

constexpr double near_D = 4.0, far_D = 1.0;

/// A near card (red 9) over columns 10…19 before a far wall whose green is its column's number.
struct CardBeforeWall {
  Image radiance{30, 12, 3};
  std::vector<double> vergence;

  CardBeforeWall() {
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 30; ++x) {
        const bool card = x >= 10 && x < 20;
        radiance.at(x, y)[card ? 0 : 1] = card ? 9.0f : static_cast<float>(x);
        vergence.push_back(card ? near_D : far_D);
      }
  }
};

double reach(double vergence_D) {
  return vergence_D == near_D ? 2.5 : 0.0;
}

TEST(Disocclusion, WallContinuesUnderTheCardsEdges) {
  const CardBeforeWall scene;
  const auto hidden = extrapolate_hidden(scene.radiance, scene.vergence, 0.5, reach);
  ASSERT_FALSE(hidden.empty());
  for (const HiddenSample& h : hidden) {
    EXPECT_TRUE((h.x >= 10 && h.x <= 12) || (h.x >= 17 && h.x <= 19)) << h.x;  // ring <= 2.5 + 0 + 1
    EXPECT_DOUBLE_EQ(h.vergence_D, far_D);
    EXPECT_EQ(h.rgb[0], 0.0f);                     // none of the card's own light
    EXPECT_EQ(h.rgb[1], h.x < 15 ? 8.0f : 21.0f);  // the first unmixed column beyond each edge (9 and 20 may be mixed)
  }
  EXPECT_EQ(hidden.size(), 6u * 12u);
}

TEST(Disocclusion, OneContinuousSurfaceHidesNothing) {
  CardBeforeWall scene;
  for (std::size_t i = 0; i < scene.vergence.size(); ++i) scene.vergence[i] = 1.0 + 0.4 * static_cast<double>(i % 30);
  EXPECT_THAT(extrapolate_hidden(scene.radiance, scene.vergence, 0.5, [](double) { return 10.0; }),
              ::testing::IsEmpty());
}

TEST(Disocclusion, TheFarSideHidesNothing) {
  CardBeforeWall scene;
  for (double& v : scene.vergence) v = v == near_D ? far_D : near_D;  // now a window: the surround is near
  for (const HiddenSample& h : extrapolate_hidden(scene.radiance, scene.vergence, 0.5, reach))
    EXPECT_TRUE(h.x < 10 || h.x >= 20);
}

}  // namespace
}  // namespace sturm
