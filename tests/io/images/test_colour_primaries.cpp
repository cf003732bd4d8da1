#include <gtest/gtest.h>

#include <Eigen/LU>
#include <stdexcept>

#include "io/images/colour_primaries.h"

namespace sturm {
namespace {

const ColourPrimaries rec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
const ColourPrimaries aces{{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.077}, {0.32168, 0.33767}};

TEST(ColourPrimaries, Rec2020AsTheRecommendationPrintsIt) {
  Eigen::Matrix3d printed;  // ITU-R BT.2087-0, section 2.2.1, four digits
  printed << 1.6605, -0.5876, -0.0728, -0.1246, 1.1329, -0.0083, -0.0182, -0.1006, 1.1187;
  EXPECT_LT((rec709_from(rec2020) - printed).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(ColourPrimaries, AcesAsTheOutputTransformsHaveIt) {
  Eigen::Matrix3d printed;  // AP0 to Rec. 709 with Bradford, as in OpenColorIO's ACES configurations (to their digits)
  printed << 2.52169, -1.13413, -0.38756, -0.27648, 1.37272, -0.09624, -0.01538, -0.15298, 1.16835;
  EXPECT_LT((rec709_from(aces) - printed).cwiseAbs().maxCoeff(), 5e-4);
}

TEST(ColourPrimaries, WhiteStaysWhite) {
  for (const ColourPrimaries& p : {rec2020, aces, ColourPrimaries{}})
    EXPECT_LT((rec709_from(p) * Eigen::Vector3d::Ones() - Eigen::Vector3d::Ones()).norm(), 1e-12);
  EXPECT_LT((rec709_from(ColourPrimaries{}) - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(ColourPrimaries, KnowsItsOwnByTheRoundingOfHeaders) {
  EXPECT_TRUE(ColourPrimaries{}.is_rec709());
  EXPECT_TRUE((ColourPrimaries{{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.31270, 0.32902}}.is_rec709()));
  EXPECT_FALSE((ColourPrimaries{{0.64, 0.33}, {0.29, 0.6}, {0.15, 0.06}, {0.3127, 0.329}}.is_rec709()));
  EXPECT_FALSE(rec2020.is_rec709());
}

TEST(ColourPrimaries, RefusesWhatSpansNoColours) {
  const Eigen::Vector2d zero(0.0, 0.0);
  EXPECT_THROW(rec709_from({zero, zero, zero, zero}), std::domain_error);
  EXPECT_THROW(rec709_from({{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, {0.9, 0.05}}), std::domain_error);
  EXPECT_THROW(rec709_from({{0.64, 0.33}, {0.64, 0.33}, {0.15, 0.06}, {0.31, 0.33}}), std::domain_error);
}

TEST(ColourPrimaries, AlphaIsNotTransformed) {
  Image image(1, 1, 4);
  image.pixels = {0.0f, 1.0f, 0.0f, 0.25f};
  transform_colours(image, rec709_from(rec2020));
  EXPECT_NEAR(image.pixels[0], -0.5876, 1e-4);
  EXPECT_NEAR(image.pixels[1], 1.1329, 1e-4);
  EXPECT_EQ(image.pixels[3], 0.25f);
}

}  // namespace
}  // namespace sturm
