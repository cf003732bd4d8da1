#include <gtest/gtest.h>

#include <limits>

#include "lensmodel/ray_model.h"

namespace sturm {
namespace {

constexpr RayModel all_models[] = {RayModel::pinhole,     RayModel::thin_lens,    RayModel::metalstigmatism,
                                   RayModel::sin2_radial, RayModel::power_matrix, RayModel::zernike};

TEST(RayModels, NamesAreReadBack) {
  for (RayModel model : all_models) EXPECT_EQ(ray_model_named(name_of(model)), model);
  EXPECT_FALSE(ray_model_named("sin2").has_value());
}

TEST(RayModels, MetalstigmatismAloneNeedsAStatedFocusDistance) {
  const Accommodation as_a_power = FixedAccommodation{0.5, 0.0};
  const Accommodation as_a_distance = FixedAccommodation{0.5, 2.0};
  const Accommodation at_infinity = FixedAccommodation{0.0, std::numeric_limits<double>::infinity()};
  for (RayModel model : all_models) {
    for (const Accommodation& stated : {as_a_distance, at_infinity}) EXPECT_TRUE(has_rays(model, stated));
    for (const Accommodation& other :
         {as_a_power, Accommodation(RelaxedAccommodation{}), Accommodation(BestAccommodation{3.0})})
      EXPECT_EQ(has_rays(model, other), model != RayModel::metalstigmatism) << name_of(model);
  }
}

}  // namespace
}  // namespace sturm
