#include <gtest/gtest.h>

#include <cmath>

#include "experiments/run/mutations.h"

namespace sturm {
namespace {

Mutation named(const std::string& id) {
  return mutations_named(std::span(&id, 1)).at(0);
}

/// −6.00 −2.00 × 30 at 12 mm before a relaxed eye.
Eye eye() {
  return Eye::with({-6.0, -2.0, 30.0, 12e-3}, 4e-3);
}

std::optional<Footprint> mutated(const std::string& id, double distance_m = 1.0) {
  return mutated_footprint(named(id), eye(), naked_eye_footprint(eye(), distance_m));
}

TEST(Mutations, SemiAxisIsOnePercentLongerAndTheOtherOneStays) {
  const Ellipse honest = Ellipse::image_of_disc(naked_eye_footprint(eye(), 1.0).angular, 2e-3);
  const Ellipse wrong = Ellipse::image_of_disc(mutated("semi_axis")->angular, 2e-3);
  EXPECT_NEAR(wrong.semi_major / honest.semi_major, 1.01, 1e-14);  // rounding
  EXPECT_NEAR(wrong.semi_minor / honest.semi_minor, 1.0, 1e-14);
  EXPECT_NEAR(*wrong.orientation_deg, *honest.orientation_deg, 1e-12);
}

TEST(Mutations, AxisTurnsByOneDegreeTheWayOfTheNotation) {
  // AXIS counts counter-clockwise as seen by the examiner: one degree more turns the ellipse clockwise for the wearer.
  const Ellipse honest = Ellipse::image_of_disc(naked_eye_footprint(eye(), 1.0).angular, 2e-3);
  EXPECT_NEAR(*Ellipse::image_of_disc(mutated("turned_axis")->angular, 2e-3).orientation_deg,
              *honest.orientation_deg - 1.0, 1e-10);
  EXPECT_NEAR(*Ellipse::image_of_disc(mutated("mirrored_axis")->angular, 2e-3).orientation_deg,
              -*honest.orientation_deg, 1e-10);
}

TEST(Mutations, VertexDistanceMakesATwentiethOfADioptreAtSix) {
  // −6 D at 12 and at 13.5 mm: 6/1.072 and 6/1.081 D at the cornea; along AXIS 30 there is the sphere alone. X/d = 1 +
  // F.
  const Eigen::Vector2d along(-std::sqrt(0.75), 0.5);  // the wearer's 150°
  const double honest = along.dot(naked_eye_footprint(eye(), 1.0).angular * along),
               wrong = along.dot(mutated("vertex_distance")->angular * along);
  EXPECT_NEAR(honest, 1.0 - 6.0 / 1.072, 1e-12);
  EXPECT_NEAR(wrong, 1.0 - 6.0 / 1.081, 1e-12);
  EXPECT_NEAR(wrong - honest, 0.0466, 1e-4);
}

TEST(Mutations, OfRaysAndPicturesLeaveTheEllipses) {
  for (const char* id : {"tangential_term", "half_pixel", "lost_light"}) EXPECT_FALSE(mutated(id)) << id;
}

TEST(Mutations, HalfAPixelIsNoBlur) {
  Image point(16, 1, 1);
  *point.at(7, 0) = 1.0f;
  const Image moved = moved_half_pixel(point);
  double light = 0.0, first = 0.0, second = 0.0;
  for (int x = 0; x < 16; ++x) {
    light += *moved.at(x, 0);
    first += *moved.at(x, 0) * (x - 7.0);
    second += *moved.at(x, 0) * (x - 7.5) * (x - 7.5);
  }
  EXPECT_EQ(light, 1.0);  // sixteenths are exact
  EXPECT_EQ(first, 0.5);
  EXPECT_EQ(second, 0.0);
}

TEST(Mutations, PicturesOfTheMutatedPredictor) {
  PredictedReplicates honest;
  Image grey(8, 8, 3);
  grey.pixels.assign(grey.pixels.size(), 0.5f);
  honest.predictions.images = {grey, grey};
  const auto dim = mutated_pictures(named("lost_light"), eye(), honest);
  ASSERT_TRUE(dim);
  EXPECT_EQ(dim->images.size(), 2u);
  EXPECT_FLOAT_EQ(dim->images[1].pixels[100], 0.495f);
  EXPECT_EQ(mutated_pictures(named("half_pixel"), eye(), honest)->images[0].pixels,
            grey.pixels);  // borders repeat: light is kept
  EXPECT_FALSE(mutated_pictures(named("semi_axis"), eye(), honest));
  EXPECT_FALSE(mutated_pictures(named("tangential_term"), eye(), honest));
}

TEST(Mutations, AnotherPrescriptionSpreadsTheSameSharpView) {
  PredictedReplicates honest;
  SharpView view{Image(33, 33, 3), Image(33, 33, 1), 0, 1e-3, 1};
  view.depth.pixels.assign(view.depth.pixels.size(), 1.0f);
  for (int c = 0; c < 3; ++c) view.radiance.at(16, 16)[c] = 1.0f;
  honest.sharp_views = {view};
  honest.predictions.images = {predict_image(view, eye(), 0.0).radiance};
  const auto mirrored = mutated_pictures(named("mirrored_axis"), eye(), honest);
  ASSERT_TRUE(mirrored);
  const Image &a = honest.predictions.images[0], &b = mirrored->images[0];
  for (int y = 0; y < 33; ++y)
    for (int x = 0; x < 33; ++x) EXPECT_NEAR(*a.at(x, y), *b.at(32 - x, y), 1e-6);  // area weights in float
  EXPECT_NE(a.pixels, b.pixels);
}

}  // namespace
}  // namespace sturm
