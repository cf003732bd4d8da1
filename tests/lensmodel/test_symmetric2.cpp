#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>

#include "lensmodel/symmetric2.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {

using Real = long double;
constexpr double unit = 0x1p-52;  // spacing of doubles at 1

// The oracle needs no rounding of its own: integer entries below 2³⁰ have determinants that fit in 64 bits.
struct IntegerMatrix {
  std::int64_t a, b, c, d;  // [[a, b], [c, d]]

  Real determinant() const { return static_cast<Real>(a * d - b * c); }
  Eigen::Matrix2d as_double() const {
    return (Eigen::Matrix2d() << static_cast<double>(a), static_cast<double>(b), static_cast<double>(c),
            static_cast<double>(d))
        .finished();
  }
};

/// Rows nearly proportional: the condition number reaches 10¹⁶.
IntegerMatrix nearly_singular() {
  const std::int64_t a = *rc::gen::inRange(-30000, 30001), b = *rc::gen::inRange(-30000, 30001),
                     k = *rc::gen::inRange(-30000, 30001);
  const auto nudge = [] { return static_cast<std::int64_t>(*rc::gen::inRange(-1, 2)); };
  return {a + nudge(), b + nudge(), k * a + nudge(), k * b + nudge()};
}

void expect_singular_values(const IntegerMatrix& n) {
  const Real e = (n.a + n.d) / Real(2), f = (n.a - n.d) / Real(2), g = (n.c + n.b) / Real(2), h = (n.c - n.b) / Real(2);
  const Real large = std::hypot(e, h) + std::hypot(f, g);
  const Real small = large > 0 ? std::abs(n.determinant()) / large : Real(0);
  const SingularValues s = singular_values(n.as_double());
  RC_ASSERT(std::abs(s.large - large) <= 4 * unit * large);
  RC_ASSERT(std::abs(s.small - small) <= 8 * unit * small);
  if (s.isotropic) return;
  // u is the left singular vector of the larger value exactly when M Mᵀ u has nothing across u.
  const Real ux = s.large_direction.x(), uy = s.large_direction.y();
  const Real wx = n.a * ux + n.c * uy, wy = n.b * ux + n.d * uy;  // Mᵀu
  const Real across = -uy * (n.a * wx + n.b * wy) + ux * (n.c * wx + n.d * wy);
  RC_ASSERT(std::abs(across) <= 8 * unit * large * large);
  RC_ASSERT(std::hypot(wx, wy) >= large * (1 - 8 * unit));
}

RC_GTEST_PROP(SingularValues, KeepTheirRelativeAccuracyNearASingularMatrix, ()) {
  expect_singular_values(nearly_singular());
}

RC_GTEST_PROP(SingularValues, KeepTheirRelativeAccuracyNearACircle, ()) {
  const std::int64_t c = *rc::gen::inRange(-1000000000, 1000000001), s = *rc::gen::inRange(-1000000000, 1000000001);
  const auto nudge = [] { return static_cast<std::int64_t>(*rc::gen::inRange(-1, 2)); };
  expect_singular_values({c + nudge(), -s + nudge(), s + nudge(), c + nudge()});
}

RC_GTEST_PROP(PrincipalValues, KeepTheirRelativeAccuracyNearAZeroEigenvalue, ()) {
  const std::int64_t p = *rc::gen::inRange(-30000, 30001), q = *rc::gen::inRange(-30000, 30001);
  const std::int64_t sign = *rc::gen::element(-1, 1);
  const IntegerMatrix n{sign * p * p + *rc::gen::inRange(-1, 2), sign * p * q, sign * p * q,
                        sign * q * q + *rc::gen::inRange(-1, 2)};
  const Real mean = (n.a + n.d) / Real(2), radius = std::hypot((n.a - n.d) / Real(2), static_cast<Real>(n.b));
  const Real big = mean >= 0 ? mean + radius : mean - radius, little = big != 0 ? n.determinant() / big : Real(0);
  const PrincipalValues v =
      principal_values(static_cast<double>(n.a), static_cast<double>(n.b), static_cast<double>(n.d));
  RC_ASSERT(v.high >= v.low);
  RC_ASSERT(std::abs((mean >= 0 ? v.high : v.low) - big) <= 4 * unit * std::abs(big));
  RC_ASSERT(std::abs((mean >= 0 ? v.low : v.high) - little) <= 8 * unit * std::abs(little));
  if (v.isotropic) return;
  const Real ux = v.high_direction.x(), uy = v.high_direction.y();
  const Real across = -uy * (n.a * ux + n.b * uy) + ux * (n.b * ux + n.d * uy);
  RC_ASSERT(std::abs(across) <= 8 * unit * std::abs(big));
  const Real along = ux * (n.a * ux + n.b * uy) + uy * (n.b * ux + n.d * uy);
  RC_ASSERT(std::abs(along - v.high) <= 8 * unit * std::abs(big));
}

TEST(PrincipalValues, ByHand) {
  const PrincipalValues v = principal_values(2.0, 1.0, 2.0);  // (1, 1) direction 3, (1, −1) direction 1
  EXPECT_EQ(v.high, 3.0);
  EXPECT_EQ(v.low, 1.0);
  EXPECT_NEAR(v.high_direction.x() * v.high_direction.y(), 0.5, 1e-15);
  EXPECT_FALSE(v.isotropic);
  EXPECT_EQ(principal_values(-1.0, 0.0, 4.0).high_direction, Eigen::Vector2d(0.0, 1.0));
  EXPECT_EQ(principal_values(4.0, 0.0, -1.0).high_direction, Eigen::Vector2d(1.0, 0.0));
}

TEST(PrincipalValues, EqualOnesHaveNoDirection) {
  EXPECT_TRUE(principal_values(0.0, 0.0, 0.0).isotropic);
  EXPECT_TRUE(principal_values(-7.0, 0.0, -7.0).isotropic);
  EXPECT_FALSE(principal_values(1.0, 0.0, -1.0).isotropic);  // opposite values are not equal
  EXPECT_FALSE(principal_values(7.0, 1e-12, 7.0).isotropic);
}

TEST(SingularValues, ByHand) {
  const SingularValues s =
      singular_values((Eigen::Matrix2d() << 0.0, -2.0, 3.0, 0.0).finished());  // e_x → 3 e_y, e_y → −2 e_x
  EXPECT_EQ(s.large, 3.0);
  EXPECT_EQ(s.small, 2.0);
  EXPECT_EQ(s.large_direction, Eigen::Vector2d(0.0, 1.0));
  EXPECT_TRUE(singular_values(Eigen::Matrix2d::Zero()).isotropic);
  EXPECT_TRUE(singular_values((Eigen::Matrix2d() << 1.0, 0.0, 0.0, -1.0).finished())
                  .isotropic);  // a mirror image of a circle is a circle
}

TEST(DifferenceOfProducts, SurvivesCancellation) {
  const double a = 1.0 + 0x1p-30;  // a² − (1 + 2⁻²⁹) = 2⁻⁶⁰ exactly; naive evaluation gives 0
  EXPECT_EQ(difference_of_products(a, a, 1.0 + 0x1p-29, 1.0), 0x1p-60);
}

}  // namespace
}  // namespace sturm
