#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lensmodel/eye.h"
#include "lensmodel/symmetric2.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {

TEST(Accommodation, HofstettersTable) {
  EXPECT_DOUBLE_EQ(hofstetter_amplitude(20.0), 12.5);
  EXPECT_DOUBLE_EQ(hofstetter_amplitude(50.0), 3.5);
  EXPECT_DOUBLE_EQ(hofstetter_amplitude(60.0), 0.5);
  EXPECT_EQ(hofstetter_amplitude(70.0), 0.0);
}

TEST(Accommodation, BestIsClampedToItsRange) {
  const Eye eye = Eye::with({-2.0, -1.0, 30.0, 0.0}, 4e-3, BestAccommodation{3.0});  // M = −2.5 D
  EXPECT_EQ(eye.accommodation_for(0.0), 0.0);  // the far point is nearer than infinity
  EXPECT_DOUBLE_EQ(eye.accommodation_for(4.0), 1.5);
  EXPECT_EQ(eye.accommodation_for(10.0), 3.0);
  const Eye hyperope = Eye::with({+2.0, 0.0, 180.0, 0.0}, 4e-3, BestAccommodation{3.0});
  EXPECT_DOUBLE_EQ(hyperope.accommodation_for(0.0), 2.0);  // accommodates for infinity already
  const Eye stiff = Eye::with({-2.0, 0.0, 180.0, 0.0}, 4e-3, BestAccommodation{0.0});
  EXPECT_EQ(stiff.accommodation_for(10.0), 0.0);
}

RC_GTEST_PROP(Accommodation, BestMakesTheLargerSemiAxisLeast, ()) {
  const Prescription rx{*rc::gen::inRange(-40, 41) * 0.25, *rc::gen::inRange(-20, 21) * 0.25,
                        static_cast<double>(*rc::gen::inRange(0, 181)), 0.0};
  const double amplitude = *rc::gen::inRange(0, 30) * 0.25, vergence = *rc::gen::inRange(0, 41) * 0.25;
  const Eye eye = Eye::with(rx, 4e-3, BestAccommodation{amplitude});
  const auto larger = [&](double accommodation) {
    return singular_values(vergence * Eigen::Matrix2d::Identity() + eye.slope_matrix(accommodation).matrix()).large;
  };
  const double best = larger(eye.accommodation_for(vergence));
  for (int k = 0; k <= 64; ++k) RC_ASSERT(best <= larger(amplitude * k / 64.0) + 1e-13);
}

TEST(Accommodation, StatedModes) {
  const Prescription emmetrope{};
  EXPECT_EQ(Eye::with(emmetrope, 4e-3).accommodation_for(5.0), 0.0);
  const Eye fixed = Eye::with(emmetrope, 4e-3, FixedAccommodation{0.5, 2.0});
  EXPECT_EQ(fixed.accommodation_for(5.0), 0.5);
  EXPECT_EQ(fixed.accommodation_for(0.0), 0.5);
  EXPECT_EQ(fixed.stated_focus_distance_m(), 2.0);
  EXPECT_FALSE(Eye::with(emmetrope, 4e-3, FixedAccommodation{0.5, 0.0}).stated_focus_distance_m().has_value());
  EXPECT_FALSE(Eye::with(emmetrope, 4e-3).stated_focus_distance_m().has_value());
}

TEST(Eye, CarriesTheCorrectionAtTheCornea) {
  const Eye eye = Eye::with({-10.0, 0.0, 180.0, 0.012}, 5e-3);
  EXPECT_NEAR(eye.correction.xx(), -8.928571428571429, 1e-14);
  EXPECT_EQ(eye.pupil_radius_m, 2.5e-3);
  EXPECT_NEAR(eye.slope_matrix(2.0).yy(), -10.928571428571429, 1e-14);  // accommodating makes the eye stronger
}

TEST(Eye, RefusesAnImpossiblePupil) {
  for (double diameter :
       {-1e-9, 0.1000001, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(Eye::with({}, diameter), std::invalid_argument) << diameter;
  EXPECT_NO_THROW(Eye::with({}, 0.0));
  EXPECT_NO_THROW(Eye::with({}, 0.1));
  EXPECT_THROW(Eye::with({41.0, 0.0, 180.0, 0.0}, 4e-3), std::invalid_argument);
}

}  // namespace
}  // namespace sturm
