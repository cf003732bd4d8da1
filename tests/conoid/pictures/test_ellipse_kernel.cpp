#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <numbers>

#include "conoid/pictures/ellipse_kernel.h"

namespace sturm {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using std::numbers::pi;

void for_each_weight(const EllipseKernel& kernel, const std::function<void(int x, int y, double weight)>& visit) {
  int y = kernel.first_row();
  for (const auto& row : kernel.rows()) {
    std::size_t edge = row.edges;
    for (int x = row.begin; x < row.end; ++x)
      visit(x, y, x >= row.inner_begin && x < row.inner_end ? kernel.inner_weight() : kernel.edge_weights()[edge++]);
    ++y;
  }
}

double sum(const EllipseKernel& kernel) {
  double total = 0.0;
  for_each_weight(kernel, [&](int, int, double w) { total += w; });
  return total;
}

double weight_at(const EllipseKernel& kernel, int x, int y) {
  double found = 0.0;
  for_each_weight(kernel, [&](int u, int v, double w) {
    if (u == x && v == y) found = w;
  });
  return found;
}

Matrix2d matrix(double a, double b, double c, double d) {
  Matrix2d m;
  m << a, b, c, d;
  return m;
}

/// Area of (ellipse ∩ box) / area of the ellipse by the midpoint rule on `n` lines: an oracle that knows nothing of
/// caps.
double weight_by_lines(const Matrix2d& map, const Vector2d& source, int px, int py, int n) {
  const Matrix2d q = (map * map.transpose()).inverse();  // the ellipse is rᵀ q r <= 1
  double area = 0.0;
  for (int i = 0; i < n; ++i) {
    const double y = py + (i + 0.5) / n - source.y();
    const double b = q(0, 1) * y, c = q(1, 1) * y * y - 1.0, discriminant = b * b - q(0, 0) * c;
    if (discriminant <= 0.0) continue;
    const double left = source.x() + (-b - std::sqrt(discriminant)) / q(0, 0),
                 right = source.x() + (-b + std::sqrt(discriminant)) / q(0, 0);
    area += std::max(0.0, std::min(right, px + 1.0) - std::max(left, static_cast<double>(px))) / n;
  }
  return area / (pi * std::abs(map.determinant()));
}

TEST(EllipseKernel, SmallEllipseStaysInItsPixel) {
  const EllipseKernel kernel(matrix(0.2, 0.1, -0.1, 0.3), {0.5, 0.5});
  EXPECT_DOUBLE_EQ(weight_at(kernel, 0, 0), 1.0);
}

TEST(EllipseKernel, CircleOnPixelCentreHasTheClosedFormSegments) {
  // Radius 1 about the centre of pixel 0: the pixel is inside (its corners are at 0.7071), the rest is shared by 4
  // edges and 4 corners.
  const EllipseKernel kernel(matrix(1, 0, 0, 1), {0.5, 0.5});
  const double segment = pi / 3.0 - std::sqrt(3.0) / 4.0;  // of a unit disc beyond a chord at distance 1/2
  // Beyond both x = 1/2 and y = 1/2: sector from 30° to 60° less two triangles with base (√3 − 1)/2 and height 1/2.
  const double corner = pi / 12.0 - 2.0 * 0.5 * 0.5 * (std::sqrt(3.0) - 1.0) / 2.0;
  EXPECT_NEAR(weight_at(kernel, 0, 0), 1.0 / pi, 1e-15);
  for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {1, -1}, {-1, -1}})
    EXPECT_NEAR(weight_at(kernel, x, y), corner / pi, 1e-15);
  for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
    EXPECT_NEAR(weight_at(kernel, x, y), (segment - 2.0 * corner) / pi, 1e-15);
}

TEST(EllipseKernel, WeightsAreAreas) {
  const Matrix2d map = matrix(3.1, 1.7, -0.4, 2.2);
  const Vector2d source(0.25, 0.75);
  const EllipseKernel kernel(map, source);
  const int n = 4000;
  for_each_weight(kernel, [&](int x, int y, double w) {
    // Midpoint rule on a chord with square-root ends: error below n^-1.5 = 4e-6 of a pixel.
    EXPECT_NEAR(w, weight_by_lines(map, source, x, y, n), 4e-6 / (pi * map.determinant())) << x << ' ' << y;
  });
}

TEST(EllipseKernel, LeansTheWayOfItsMatrix) {
  // Along (1, 1): more light in the pixels right-down (y is down) and left-up than in the others.
  const EllipseKernel kernel(matrix(2, 1.8, 1.8, 2), {0.5, 0.5});
  EXPECT_GT(weight_at(kernel, 2, 2), 0.02);
  EXPECT_GT(weight_at(kernel, -2, -2), 0.02);
  EXPECT_EQ(weight_at(kernel, 2, -2), 0.0);
  EXPECT_EQ(weight_at(kernel, -2, 2), 0.0);
}

RC_GTEST_PROP(EllipseKernel, WeightsSumToOneAndCarryTheMoments, ()) {
  const auto entry = [] { return *rc::gen::inRange(-20000, 20001) * 1e-3; };
  const Matrix2d map = matrix(entry(), entry(), entry(), entry());
  const Vector2d source(*rc::gen::inRange(1, 1000) * 1e-3, *rc::gen::inRange(1, 1000) * 1e-3);
  const EllipseKernel kernel(map, source);
  Vector2d mean = Vector2d::Zero();
  double total = 0.0, smallest = 1.0;
  int rows_outside = 0;
  for_each_weight(kernel, [&](int x, int y, double w) {
    total += w;
    smallest = std::min(smallest, w);
    mean += w * Vector2d(x + 0.5, y + 0.5);
    if (y + 1 < source.y() - map.row(1).norm() - 1e-9 || y > source.y() + map.row(1).norm() + 1e-9) ++rows_outside;
  });
  RC_ASSERT(std::abs(total - 1.0) <
            1e-11);  // some 200 edge weights of area error 1e-16 · 1/sin, near-degenerate ones the worst
  RC_ASSERT(smallest >= 0.0);
  RC_ASSERT(rows_outside == 0);
  // Pixel centres quantise the position by at most half a pixel.
  RC_ASSERT((mean - source).cwiseAbs().maxCoeff() <= 0.5 + 1e-9);
}

TEST(EllipseKernel, FocalLineKeepsTheProjectedDensityOfTheDisc) {
  // Rank 1: the disc collapses to a horizontal line of half length 5; its density is 2/π √(1 − s²) ds.
  const EllipseKernel kernel(matrix(3, 4, 0, 0), {0.5, 0.5});
  const auto cumulative = [](double s) { return (std::asin(s) + s * std::sqrt(1.0 - s * s)) / pi; };
  ASSERT_EQ(kernel.rows().size(), 1u);
  EXPECT_NEAR(weight_at(kernel, 0, 0), 2.0 * cumulative(0.1), 1e-15);
  EXPECT_NEAR(weight_at(kernel, 3, 0), cumulative(0.7) - cumulative(0.5), 1e-15);
  EXPECT_NEAR(sum(kernel), 1.0, 1e-14);

  const EllipseKernel upright(matrix(0, 0, 3, 4), {0.5, 0.5});
  EXPECT_NEAR(weight_at(upright, 0, 3), cumulative(0.7) - cumulative(0.5), 1e-15);
  EXPECT_NEAR(sum(upright), 1.0, 1e-14);
}

TEST(EllipseKernel, ObliqueFocalLineRunsThroughDiagonalPixels) {
  const EllipseKernel kernel(matrix(2.2, 0, 2.2, 0), {0.5, 0.5});
  EXPECT_NEAR(sum(kernel), 1.0, 1e-14);
  for_each_weight(kernel,
                  [](int x, int y, double w) { EXPECT_TRUE(x == y || w < 1e-15) << x << ' ' << y << ' ' << w; });
  EXPECT_GT(weight_at(kernel, -2, -2), 0.05);
}

TEST(EllipseKernel, ThinEllipseApproachesTheLine) {
  const EllipseKernel line(matrix(6, 0, 2, 0), {0.5, 0.5}), thin(matrix(6, 1e-9, 2, -2e-9), {0.5, 0.5});
  for_each_weight(
      line, [&](int x, int y, double w) { EXPECT_NEAR(w, weight_at(thin, x, y), 1e-7); });  // ∝ width, and 1e-16/sin
}

TEST(EllipseKernel, PointSourceWithoutBlurIsCopied) {
  const EllipseKernel kernel(Matrix2d::Zero(), {0.25, 0.75});
  EXPECT_EQ(sum(kernel), 1.0);
  EXPECT_EQ(weight_at(kernel, 0, 0), 1.0);
}

}  // namespace
}  // namespace sturm
