#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "experiments/figures/lens_maps.h"
#include "lensmodel/progressive.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::mm;

constexpr double center = 13.5 * mm, far_away = std::numeric_limits<double>::infinity();
constexpr int middle = lens_map_samples / 2;

/// A thin plane pane: 12 mm before the pupil, 1 mm thick, index 1.5.
Spectacles pane() {
  Spectacles lens;
  lens.center_thickness_m = 1 * mm;
  lens.diameter_m = 40 * mm;
  return lens;
}

TEST(DefocusMap, BehindAPaneTheTargetsVergenceIsLacking) {
  // From the pupil a target 0.5 m before the front surface is 0.5 + 0.012 + 0.001/1.5 m away: 1.950585 D are lacking.
  const PowerMatrix none = PowerMatrix::scalar(0.0);
  EXPECT_NEAR(defocus_map(pane(), none, center, 0.5, 0.0).values(middle, middle), -1.9505851755526658, 1e-12);
  EXPECT_EQ(defocus_map(pane(), none, center, 0.5, 3.0).values(middle, middle), 0.0);
  EXPECT_NEAR(defocus_map(pane(), none, center, 0.5, 1.0).values(middle, middle), -0.9505851755526659, 1e-12);
  EXPECT_NEAR(defocus_map(pane(), none, center, far_away, 3.0).values(middle, middle), 0.0, 1e-12);
  // An uncorrected myope of 1 D has too much for what is far, and accommodation cannot help.
  EXPECT_NEAR(defocus_map(pane(), PowerMatrix::scalar(-1.0), center, far_away, 3.0).values(middle, middle), 1.0, 1e-12);
}

TEST(DefocusMap, TheLimitIsTheLargerPrincipalValue) {
  const LensMap map = defocus_map(pane(), PowerMatrix::from({-1.0, -2.0, 30.0}), center, far_away, 0.0);
  EXPECT_NEAR(map.values(middle, middle), 2.0, 1e-12);
  EXPECT_NEAR((*map.limit_values)(middle, middle), 3.0, 1e-12);
}

TEST(LensMaps, PlacesOutsideOfTheRimHaveNoValue) {
  const LensMap map = defocus_map(pane(), PowerMatrix::scalar(0.0), center, 0.5, 0.0);
  EXPECT_EQ(map.rim_radius_mm, 20.0);
  EXPECT_EQ(map.fitting_cross_mm.norm(), 0.0);
  EXPECT_TRUE(std::isnan(map.values(0, 0)));
  EXPECT_TRUE(std::isfinite(map.values(middle, middle + middle / 2)));
}

TEST(LensMaps, ACorrectedEyeLacksNothingInTheMiddle) {
  const Prescription rx{-4.0, -2.0, 30.0};
  const Spectacles lens = single_vision(rx, {});
  const auto maps = as_worn_maps(lens, PowerMatrix::from(rx), center);
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_NEAR(maps[0].values(middle, middle), 0.0, 1e-11);
  EXPECT_NEAR(maps[1].values(middle, middle), 0.0, 1e-11);
  EXPECT_TRUE(maps[0].signed_scale && !maps[1].signed_scale);
  const LensMap lack = defocus_map(lens, PowerMatrix::from(rx).moved_towards_eye(12 * mm), center, far_away, 0.0);
  EXPECT_NEAR((*lack.limit_values)(middle, middle), 0.0, 1e-11);
}

TEST(LensMaps, RowsRunUpAndColumnsToTheWearersRight) {
  ProgressiveDesign design;
  design.lens.base_curve_D = 5.5;
  design.lens.diameter_m = 50 * mm;
  design.addition_D = 2.0;
  design.near_shift_m = -4 * mm;
  design.zone_width_m = 8 * mm;
  design.knot_spacing_m = 0.5 * mm;
  const auto maps = as_worn_maps(progressive_lens({-1.0}, design).lens, PowerMatrix::scalar(-1.0), center);
  const auto at = [&](double x_mm, double y_mm) {
    const auto index = [](double mm_on_lens) {
      return static_cast<int>(std::lround((mm_on_lens / 25.0 + 1.0) * middle));
    };
    return maps[0].values(index(y_mm), index(x_mm));
  };
  EXPECT_LT(std::abs(at(0, 15)), 0.2);  // far zone: the oblique error of a lens of −1 D
  EXPECT_GT(at(-4, -18), 1.6);          // near zone below, towards the nose of a right eye
  EXPECT_GT(at(-4, -18) - at(4, -18), 0.4);
}

TEST(LensMaps, TheDifferenceOfTwoLensesIsTheirPowersDifference) {
  const Spectacles weak = single_vision({-2.0, -1.0, 30.0}, {}), strong = single_vision({-1.5, -1.0, 30.0}, {});
  const auto maps = as_worn_difference(weak, strong, center);
  EXPECT_NEAR(maps[0].values(middle, middle), 0.5, 1e-11);  // the second has half a dioptre more
  EXPECT_NEAR(maps[1].values(middle, middle), 0.0, 1e-11);
}

TEST(LensMaps, ADecentredLensHasItsCrossAside) {
  SingleVisionDesign design;
  design.mounting = Mounting({3 * mm, -2 * mm}, 0.0, 0.0);
  const LensMap map = as_worn_maps(single_vision({-3.0}, design), PowerMatrix::scalar(-3.0), center)[0];
  EXPECT_NEAR(map.fitting_cross_mm.x(), -3.0,
              1e-9);  // the lens went to the right: the pupil looks through a place left of its vertex
  EXPECT_NEAR(map.fitting_cross_mm.y(), 2.0, 1e-9);
}

}  // namespace
}  // namespace sturm
