#include "lensmodel/zernike_wave.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lensmodel/zernike_order.h"

namespace sturm {

namespace {

constexpr int highest_order = 20;

double factorial(int n) {
  return std::tgamma(n + 1.0);
}

}  // namespace

ZernikeWave::ZernikeWave(std::vector<double> coefficients, double radius_m)
    : coefficients_(std::move(coefficients)), radius_(radius_m) {
  if (coefficients_.empty()) coefficients_.push_back(0.0);
  const int highest = ZernikeIndex::of(static_cast<int>(coefficients_.size()) - 1).n;
  if (!(radius_m > 0.0)) throw std::invalid_argument("a wavefront needs a pupil");
  if (highest > highest_order) throw std::invalid_argument("Zernike orders go to 20");
  height_ = PlanePolynomial(highest);
  for (std::size_t j = 0; j < coefficients_.size(); ++j) {
    if (coefficients_[j] == 0.0) continue;
    const PlanePolynomial z = zernike_polynomial(static_cast<int>(j));
    for (int k = 0; k <= z.degree(); ++k)
      for (int i = 0; i + k <= z.degree(); ++i) height_.at(i, k) += coefficients_[j] * z.at(i, k);
  }
  PlanePolynomial scaled = height_;
  for (int k = 0; k <= highest; ++k)
    for (int i = 0; i + k <= highest; ++i) scaled.at(i, k) *= -1.0 / radius_m;
  slope_x_ = scaled.derivative_x();
  slope_y_ = scaled.derivative_y();
}

ZernikeWave ZernikeWave::from_examiner(std::span<const double> coefficients_m, double radius_m) {
  return ZernikeWave(mirrored(coefficients_m), radius_m);
}

ZernikeWave ZernikeWave::of_power(const PowerMatrix& power, double a) {
  std::vector<double> c(6, 0.0);
  c[0] = c[4] = -power.spherical_equivalent() * a * a / (4.0 * std::numbers::sqrt3);
  c[0] *= std::numbers::sqrt3;  // so that W vanishes at the centre
  c[5] = -0.25 * (power.xx() - power.yy()) * a * a / std::sqrt(6.0);
  c[3] = -0.5 * power.xy() * a * a / std::sqrt(6.0);
  return ZernikeWave(std::move(c), a);
}

ZernikeWave ZernikeWave::rescaled(double radius_m) const {
  if (!(radius_m > 0.0 && radius_m <= radius_))
    throw std::invalid_argument("a wavefront says nothing beyond its own pupil");
  const double ratio = radius_m / radius_;
  std::vector<double> c(coefficients_.size(), 0.0);
  const auto size = static_cast<int>(c.size());
  // Dai, J. Opt. Soc. Am. A 23, 539 (2006), eq. 20.
  for (int j = 0; j < size; ++j) {
    const auto [n, m] = ZernikeIndex::of(j);
    double sum = coefficients_[static_cast<std::size_t>(j)];
    for (int i = 1;; ++i) {
      const int from = ZernikeIndex{n + 2 * i, m}.single();
      if (from >= size) break;
      double inner = 0.0;
      for (int k = 0; k <= i; ++k)
        inner += ((i + k) % 2 ? -1.0 : 1.0) * factorial(n + i + k) /
                 (factorial(n + k + 1) * factorial(i - k) * factorial(k)) * std::pow(ratio, 2 * k);
      sum += coefficients_[static_cast<std::size_t>(from)] * std::sqrt((n + 1.0) * (n + 2.0 * i + 1.0)) * inner;
    }
    c[static_cast<std::size_t>(j)] = std::pow(ratio, n) * sum;
  }
  return ZernikeWave(std::move(c), radius_m);
}

ZernikeWave ZernikeWave::plus(const ZernikeWave& other) const {
  if (radius_ != other.radius_) throw std::invalid_argument("wavefronts over different pupils");
  std::vector<double> c(std::max(coefficients_.size(), other.coefficients_.size()), 0.0);
  for (std::size_t j = 0; j < coefficients_.size(); ++j) c[j] += coefficients_[j];
  for (std::size_t j = 0; j < other.coefficients_.size(); ++j) c[j] += other.coefficients_[j];
  return ZernikeWave(std::move(c), radius_);
}

double ZernikeWave::height(const Eigen::Vector2d& p) const {
  return height_(p.x() / radius_, p.y() / radius_);
}

Eigen::Vector2d ZernikeWave::slope(const Eigen::Vector2d& p) const {
  const double x = p.x() / radius_, y = p.y() / radius_;
  return {slope_x_(x, y), slope_y_(x, y)};
}

PowerMatrix ZernikeWave::power(SecondOrder rule) const {
  const double a2 = radius_ * radius_;
  if (rule == SecondOrder::Paraxial) {
    if (height_.degree() < 2) return PowerMatrix();
    return PowerMatrix::from_components(-2.0 * height_.at(2, 0) / a2, -height_.at(1, 1) / a2,
                                        -2.0 * height_.at(0, 2) / a2);
  }
  const auto c = [&](std::size_t j) { return j < coefficients_.size() ? coefficients_[j] : 0.0; };
  const double mean = -4.0 * std::numbers::sqrt3 * c(4) / a2, straight = -2.0 * std::sqrt(6.0) * c(5) / a2,
               oblique = -2.0 * std::sqrt(6.0) * c(3) / a2;
  return PowerMatrix::from_components(mean + straight, oblique, mean - straight);
}

}  // namespace sturm
