#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pathtrace/sampling/disk.h"
#include "pathtrace/sampling/pupil_points.h"
#include "pathtrace/sampling/vector_math.h"

namespace sturm {
namespace {

template <class T>
double jacobian(T u, T v, T h) {
  const auto right = concentric_disk<T>(u + h, v), left = concentric_disk<T>(u - h, v);
  const auto above = concentric_disk<T>(u, v + h), below = concentric_disk<T>(u, v - h);
  const double scale = 1.0 / (4.0 * static_cast<double>(h) * static_cast<double>(h));
  return scale * (static_cast<double>(right.x - left.x) * static_cast<double>(above.y - below.y) -
                  static_cast<double>(right.y - left.y) * static_cast<double>(above.x - below.x));
}

/// Distance in (u, v) to the diagonals, where the two halves of the map meet with a kink.
double to_diagonals(double u, double v) {
  return std::min(std::abs(u - v), std::abs(u + v - 1.0));
}

// The unit square has area 1 and the disc π, so the map preserves area exactly when its Jacobian is +π everywhere.
TEST(ConcentricDisk, JacobianIsPiEverywhereInDouble) {
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const double u = (i + 0.37) / 64.0, v = (j + 0.41) / 64.0;
      if (to_diagonals(u, v) < 1e-3) continue;
      // Truncation h²·|f'''| ≤ 1e−10/r² with r ≥ 1e−3·2, rounding 1e−16/h.
      EXPECT_NEAR(jacobian(u, v, 1e-6), std::numbers::pi, 2e-6) << u << " " << v;
    }
}

TEST(ConcentricDisk, JacobianIsPiEverywhereInFloat) {
  constexpr float h = 1.0f / 256.0f;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const float u = (static_cast<float>(i) + 0.37f) / 64.0f, v = (static_cast<float>(j) + 0.41f) / 64.0f;
      const double from_border = std::min(std::min(u, 1.0f - u), std::min(v, 1.0f - v)),
                   from_center = std::max(std::abs(u - 0.5f), std::abs(v - 0.5f));
      if (to_diagonals(u, v) < 2.0 * h || from_border < h || from_center < 0.1) continue;
      // Truncation (h/0.1)²/6 = 2.5e−4 relative, rounding 6e−8/h = 1.5e−5.
      EXPECT_NEAR(jacobian(u, v, h), std::numbers::pi, 2e-3) << u << " " << v;
    }
}

TEST(ConcentricDisk, BorderGoesToTheUnitCircleAndCentreToTheCentre) {
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0;
    for (const auto& [u, v] : {std::pair{t, 0.0}, {t, 1.0}, {0.0, t}, {1.0, t}}) {
      const auto d = concentric_disk(u, v);
      EXPECT_NEAR(std::hypot(d.x, d.y), 1.0, 4e-16);
      const auto f = concentric_disk(static_cast<float>(u), static_cast<float>(v));
      EXPECT_NEAR(std::hypot(f.x, f.y), 1.0, 2e-7);  // two roundings of 6e−8 and the series' 4e−8
    }
  }
  EXPECT_EQ(concentric_disk(0.5, 0.5).x, 0.0);
  EXPECT_EQ(concentric_disk(0.5, 0.5).y, 0.0);
}

TEST(ConcentricDisk, KeepsRightRightAndUpUp) {
  EXPECT_EQ(concentric_disk(1.0, 0.5).x, 1.0);
  EXPECT_EQ(concentric_disk(0.5, 1.0).y, 1.0);
  EXPECT_EQ(concentric_disk(0.0, 0.5).x, -1.0);
  EXPECT_EQ(concentric_disk(0.5, 0.0).y, -1.0);
}

TEST(ConcentricDisk, AgreesWithTheLibrarysSineAndCosine) {
  for (int i = 0; i < 500; ++i)
    for (int j = 0; j < 500; ++j) {
      const double u = i / 512.0 + 0x1p-10, v = j / 512.0 + 0x1p-11;  // exact in float too
      constexpr long double pi = std::numbers::pi_v<long double>;
      const long double a = 2.0 * u - 1.0, b = 2.0 * v - 1.0;
      const bool wide = std::abs(a) > std::abs(b);
      const long double radius = wide ? a : b;
      const long double angle = wide ? 0.25L * pi * b / a : 0.5L * pi - (b == 0.0L ? 0.0L : 0.25L * pi * a / b);
      const auto x = static_cast<double>(radius * std::cos(angle)), y = static_cast<double>(radius * std::sin(angle));
      const auto d = concentric_disk(u, v);
      ASSERT_NEAR(d.x, x, 3e-16);  // roundings of the angle, the series and the product
      ASSERT_NEAR(d.y, y, 3e-16);
      const auto f = concentric_disk(static_cast<float>(u), static_cast<float>(v));
      ASSERT_NEAR(f.x, x, 1.6e-7);  // 4e−8 of the series and two roundings
      ASSERT_NEAR(f.y, y, 1.6e-7);
    }
}

TEST(TangentFrame, IsRightHandedAndOrthonormal) {
  for (const Eigen::Vector3f& direction :
       {Eigen::Vector3f(0, 0, 1), {0, 0, -1}, {1, 0, 0}, {-0.3f, 0.8f, -0.2f}, {1e-4f, -1e-4f, -1.0f}}) {
    const Eigen::Vector3f n = direction.normalized();
    const TangentFrame frame(n);
    Eigen::Matrix3f m;
    m << frame.tangent, frame.bitangent, n;
    EXPECT_LT((m.transpose() * m - Eigen::Matrix3f::Identity()).cwiseAbs().maxCoeff(), 5e-7f);  // a few float roundings
    EXPECT_NEAR(m.determinant(), 1.0f, 5e-7f);
  }
}

// Density cos θ/π means: one unit of (u, v) area covers π/cos θ of solid angle.
TEST(CosineDirection, JacobianIsPiOverCosine) {
  const Eigen::Vector3f n = Eigen::Vector3f(0.3f, -0.5f, 0.7f).normalized();
  constexpr float h = 1.0f / 256.0f;
  for (float u : {0.12f, 0.33f, 0.62f, 0.85f})
    for (float v : {0.2f, 0.43f, 0.72f, 0.9f}) {
      const Eigen::Vector3d du =
          (direction_about(n, cosine_local(u + h, v)) - direction_about(n, cosine_local(u - h, v))).cast<double>() /
          (2.0 * h);
      const Eigen::Vector3d dv =
          (direction_about(n, cosine_local(u, v + h)) - direction_about(n, cosine_local(u, v - h))).cast<double>() /
          (2.0 * h);
      const Eigen::Vector3f w = direction_about(n, cosine_local(u, v));
      EXPECT_NEAR(w.norm(), 1.0f, 1e-6f);
      const double solid_angle = std::sqrt(du.squaredNorm() * dv.squaredNorm() - std::pow(du.dot(dv), 2));
      EXPECT_NEAR(solid_angle * static_cast<double>(n.dot(w)) / std::numbers::pi, 1.0, 0.01)
          << u << " " << v;  // O(h²) near the horizon
    }
}

TEST(DiskQuadrature, IntegratesMonomialsExactly) {
  const auto rule = disk_quadrature(6, 13);
  double one = 0, x = 0, xx = 0, xy = 0, x4y2 = 0;
  for (const WeightedPoint& w : rule) {
    const double px = w.point.x(), py = w.point.y();
    one += w.weight;
    x += w.weight * px;
    xx += w.weight * px * px;
    xy += w.weight * px * py;
    x4y2 += w.weight * px * px * px * px * py * py;
  }
  EXPECT_NEAR(one, 1.0, 1e-14);
  EXPECT_NEAR(x, 0.0, 1e-15);
  EXPECT_NEAR(xx, 1.0 / 4.0, 1e-15);
  EXPECT_NEAR(xy, 0.0, 1e-15);
  EXPECT_NEAR(x4y2, 1.0 / 64.0, 1e-15);  // E[r⁶] = 1/4, E[cos⁴ sin²] = 1/16
}

TEST(UnitDiskPoints, ReplicatesDifferAndAddressingIsConsistent) {
  std::vector<Eigen::Vector2d> all(64), tail(32), other(64);
  fill_unit_disk(Sequence::Sobol, 5, 0, 0, all);
  fill_unit_disk(Sequence::Sobol, 5, 0, 32, tail);
  fill_unit_disk(Sequence::Sobol, 5, 1, 0, other);
  for (std::size_t i = 0; i < tail.size(); ++i) EXPECT_EQ(all[32 + i], tail[i]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NE(all[i], other[i]);
    EXPECT_LE(all[i].norm(), 1.0);
  }
}

}  // namespace
}  // namespace sturm
