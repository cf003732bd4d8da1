#include "compare/psf/pixel_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compare/psf/circle_area.h"

namespace sturm {

namespace {

constexpr int margin = 36;                           // 0.43^36: the spline's coefficients die out like that
constexpr int parts = 8;                             // of a pixel on the circle, each way
constexpr double reach = 0.5 * std::numbers::sqrt2;  // of a pixel's corners from its middle

/// Poles of the filter from samples to coefficients: zeros of z⁴ + 26z³ + 66z² + 26z + 1 within the unit circle.
constexpr std::array<double, 2> poles{-0.430575347099973, -0.0430962882032647};

/// Integrals of the quintic B-spline over the unit cells at 0, ±1, ±2, ±3: the B-spline of degree 6 there.
constexpr std::array<double, 4> cell_integrals{5887.0 / 11520.0, 10543.0 / 46080.0, 361.0 / 23040.0, 1.0 / 46080.0};

double quintic_b_spline(double x) {
  const double a = std::abs(x), b = a * a;
  if (a < 1.0) return 0.55 - 0.5 * b + 0.25 * b * b - b * b * a / 12.0;
  if (a < 2.0) return 0.425 + 0.625 * a - 1.75 * b + 1.25 * b * a - 0.375 * b * b + b * b * a / 24.0;
  return a < 3.0 ? std::pow(3.0 - a, 5) / 120.0 : 0.0;
}

/// Turns samples into coefficients, in place; there is no light beyond either end.
template <class Line>
void filter(Line line) {
  const Eigen::Index n = line.size();
  for (const double pole : poles) {
    for (Eigen::Index i = 1; i < n; ++i) line(i) += pole * line(i - 1);
    line(n - 1) /= 1.0 - pole * pole;  // what the sums behind the end add up to
    for (Eigen::Index i = n - 1; i-- > 0;) line(i) += pole * line(i + 1);
    line *= (1.0 - pole) * (1.0 - pole);
  }
}

/// Sums over `line` with the weights of cell_integrals, in place.
template <class Line>
void integrate_over_cells(Line line) {
  const Eigen::VectorXd values = line;
  for (Eigen::Index i = 3; i + 3 < values.size(); ++i) {
    line(i) = cell_integrals[0] * values(i);
    for (int d = 1; d <= 3; ++d)
      line(i) += cell_integrals[static_cast<std::size_t>(d)] * (values(i - d) + values(i + d));
  }
}

/// The B-splines of the cells from 3 before to 3 behind, at the middles of a cell's parts.
using PartWeights = Eigen::Matrix<double, parts, 7>;

double part_place(int part) {
  return (part + 0.5) / parts - 0.5;
}

/// What pixels, or cells of the density, have of `gaussian` at 0, 1, …, `count` − 1.
template <class Light>
Eigen::VectorXd at_cells(int count, const Light& light) {
  Eigen::VectorXd values(count);
  for (int i = 0; i < count; ++i) values(i) = light(i);
  return values;
}

PartWeights part_weights() {
  PartWeights weights;
  for (int part = 0; part < parts; ++part)
    for (int d = -3; d <= 3; ++d) weights(part, d + 3) = quintic_b_spline(part_place(part) - d);
  return weights;
}

}  // namespace

PixelLight::PixelLight(const PointSpread& spread) : side_arcmin_(spread.cell_arcmin) {
  Eigen::Vector2d low = spread.points.front(), high = low;
  for (const Eigen::Vector2d& p : spread.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const auto cell_of = [&](const Eigen::Vector2d& p) -> Eigen::Vector2i {
    return ((p - low) / side_arcmin_).array().round().cast<int>() + margin;
  };
  const Eigen::Vector2i size = cell_of(high).array() + margin + 1;
  centroid_ = (spread.centroid() - low) / side_arcmin_ + Eigen::Vector2d::Constant(margin);
  coefficients_ = Eigen::MatrixXd::Zero(size.x(), size.y());
  for (std::size_t i = 0; i < spread.points.size(); ++i) {
    const Eigen::Vector2i cell = cell_of(spread.points[i]);
    coefficients_(cell.x(), cell.y()) += spread.weights[i];
  }
  gaussians_ = {PixelGaussian(coefficients_.rowwise().sum()), PixelGaussian(coefficients_.colwise().sum().transpose())};
  const auto pixels_of = [](const PixelGaussian& g, Eigen::Index count) {
    return at_cells(static_cast<int>(count), [&](int i) { return g.pixel(i); });
  };
  const auto cells_of = [](const PixelGaussian& g, Eigen::Index count) {
    return at_cells(static_cast<int>(count), [&](int i) { return g.light(i, 1.0); });
  };
  coefficients_ -= pixels_of(gaussians_[0], size.x()) * pixels_of(gaussians_[1], size.y()).transpose();
  for (int y = 0; y < size.y(); ++y) filter(coefficients_.col(y));
  for (int x = 0; x < size.x(); ++x) filter(coefficients_.row(x));
  Eigen::MatrixXd light = coefficients_;
  for (int y = 0; y < size.y(); ++y) integrate_over_cells(light.col(y));
  for (int x = 0; x < size.x(); ++x) integrate_over_cells(light.row(x));
  light += cells_of(gaussians_[0], size.x()) * cells_of(gaussians_[1], size.y()).transpose();
  for (int y = 3; y + 3 < size.y(); ++y)
    for (int x = 3; x + 3 < size.x(); ++x)
      cells_.push_back({(Eigen::Vector2d(x, y) - centroid_).norm(), light(x, y), x, y});
  std::stable_sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) { return a.distance < b.distance; });
  light_before_.push_back(0.0);
  for (const Cell& cell : cells_) light_before_.push_back(light_before_.back() + cell.light);
}

double PixelLight::light_on_circle(const Cell& cell, double radius) const {
  static const PartWeights weights = part_weights();
  Eigen::Vector<double, parts> column, row;
  for (int part = 0; part < parts; ++part) {
    column(part) = parts * gaussians_[0].light(cell.x + part_place(part), 1.0 / parts);
    row(part) = parts * gaussians_[1].light(cell.y + part_place(part), 1.0 / parts);
  }
  const Eigen::Matrix<double, parts, parts> density =
      weights * coefficients_.block<7, 7>(cell.x - 3, cell.y - 3) * weights.transpose() + column * row.transpose();
  const Eigen::Vector2d middle = Eigen::Vector2d(cell.x, cell.y) - centroid_;
  double inside = 0.0, area = 0.0;
  for (int j = 0; j < parts; ++j)
    for (int i = 0; i < parts; ++i) {
      const double common =
          area_within_circle(middle + Eigen::Vector2d(part_place(i), part_place(j)), 1.0 / parts, radius);
      inside += density(i, j) * common, area += common;
    }
  // The parts' midpoints do not quite add up to the cell: with this they do where all of it is inside.
  return inside + (cell.light - density.mean()) * area;
}

double PixelLight::share(double radius) const {
  const auto is_nearer = [](const Cell& cell, double distance) { return cell.distance < distance; };
  const auto first = std::lower_bound(cells_.begin(), cells_.end(), radius - reach, is_nearer);
  const auto last = std::lower_bound(first, cells_.end(), radius + reach, is_nearer);
  double sum = light_before_[static_cast<std::size_t>(first - cells_.begin())];
  for (auto cell = first; cell != last; ++cell) sum += light_on_circle(*cell, radius);
  return sum;
}

double PixelLight::within(double radius_arcmin) const {
  return std::clamp(share(radius_arcmin / side_arcmin_), 0.0, 1.0);
}

double PixelLight::radius_of(double energy) const {
  const auto passes = std::lower_bound(light_before_.begin(), light_before_.end(), energy);
  const auto index = std::min(static_cast<std::size_t>(passes - light_before_.begin()), cells_.size());
  const double near = cells_[index == 0 ? 0 : index - 1].distance;
  double low = std::max(0.0, near - 1.0), high = near + 1.0;
  while (low > 0.0 && share(low) >= energy) low = std::max(0.0, low - 1.0);
  while (high < cells_.back().distance && share(high) < energy) high += 1.0;
  for (int halvings = 0; halvings < 60 && high - low > 1e-14 * high; ++halvings) {
    const double middle = 0.5 * (low + high);
    (share(middle) < energy ? low : high) = middle;
  }
  return side_arcmin_ * high;
}

}  // namespace sturm
