#include "wavefront/layers/ray_deposit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/files/formatted_text.h"

namespace sturm {

namespace {

constexpr double of_no_account = 1e-7;  // share of the light that the rim of a kernel may lack

/// Light on a square of pixels.
class Deposit {
 public:
  explicit Deposit(int radius)
      : radius_(radius),
        side_(2 * radius + 1),
        light_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 0.0),
        widening_(light_.size(), 0.0) {}

  /// On the pixel that it lands in.
  void add_whole(const LandedRay& ray) {
    light_[index(static_cast<int>(std::floor(ray.place.x() + 0.5)),
                 static_cast<int>(std::floor(ray.place.y() + 0.5)))] += ray.weight;
  }

  /// On the four pixels about its place.
  void add_shared(const LandedRay& ray) {
    const double left = std::floor(ray.place.x()), above = std::floor(ray.place.y());
    const double f = ray.place.x() - left, g = ray.place.y() - above;
    const std::size_t at = index(static_cast<int>(left), static_cast<int>(above));
    const double variance = 0.5 * (f * (1.0 - f) + g * (1.0 - g));  // of two pixels' weights, mean of both axes
    const auto add = [&](std::size_t cell, double share) {
      light_[cell] += ray.weight * share;
      widening_[cell] += ray.weight * share * variance;
    };
    add(at, (1.0 - f) * (1.0 - g));
    add(at + 1, f * (1.0 - g));
    add(at + static_cast<std::size_t>(side_), (1.0 - f) * g);
    add(at + static_cast<std::size_t>(side_) + 1, f * g);
  }

  /// Its middle that holds all light but for what is of no account.
  SpreadKernel kernel() const {
    SpreadKernel kernel;
    kernel.radius_px = radius_of_light();
    kernel.weights.resize(static_cast<std::size_t>(kernel.side()) * static_cast<std::size_t>(kernel.side()));
    kernel.widening_px2 = widening_px2();
    double held = 0.0;
    for_each_within(kernel.radius_px, [&](int dx, int dy) { held += light_[index(dx, dy)]; });
    for_each_within(kernel.radius_px,
                    [&](int dx, int dy) { kernel.weight(dx, dy) = static_cast<float>(light_[index(dx, dy)] / held); });
    return kernel;
  }

 private:
  std::size_t index(int dx, int dy) const {
    return static_cast<std::size_t>(dy + radius_) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(dx + radius_);
  }

  template <class Visit>
  static void for_each_within(int radius, Visit visit) {
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) visit(dx, dy);
  }

  /// The mean over the light, each pixel's counted by its own brightness: what a kernel leaves of fine detail went
  /// through its bright core.
  double widening_px2() const {
    double sum = 0.0, weights = 0.0;
    for (std::size_t i = 0; i < light_.size(); ++i) {
      sum += widening_[i] * light_[i];
      weights += light_[i] * light_[i];
    }
    return sum / weights;
  }

  int radius_of_light() const {
    std::vector<double> rings(static_cast<std::size_t>(radius_) + 1, 0.0);
    double all = 0.0, left_out = 0.0;
    for_each_within(radius_, [&](int dx, int dy) {
      rings[static_cast<std::size_t>(std::max(std::abs(dx), std::abs(dy)))] += light_[index(dx, dy)];
      all += light_[index(dx, dy)];
    });
    for (int r = radius_; r > 0; --r) {
      left_out += rings[static_cast<std::size_t>(r)];
      if (left_out > of_no_account * all) return r;
    }
    return 0;
  }

  int radius_, side_;
  std::vector<double> light_;
  std::vector<double> widening_;  // of each pixel: variance that sharing adds, times light
};

}  // namespace

SpreadKernel deposited(std::span<const LandedRay> rays, int largest_radius_px, RayShare share) {
  double reach = 0.0;
  for (const LandedRay& ray : rays) reach = std::max(reach, ray.place.lpNorm<Eigen::Infinity>());
  if (!(reach < largest_radius_px))
    throw std::invalid_argument("the blur reaches " + plain_number(std::round(reach)) + " pixels, more than " +
                                std::to_string(largest_radius_px));
  Deposit deposit(static_cast<int>(reach) + 2);
  for (const LandedRay& ray : rays)
    if (share == RayShare::FourPixels)
      deposit.add_shared(ray);
    else
      deposit.add_whole(ray);
  return deposit.kernel();
}

}  // namespace sturm
