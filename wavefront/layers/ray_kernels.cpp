#include "wavefront/layers/ray_kernels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "lensmodel/chromatic_eye.h"
#include "wavefront/layers/primaries.h"
#include "wavefront/layers/pupil_parts.h"
#include "wavefront/layers/ray_deposit.h"

namespace sturm {

namespace {

using Eigen::Vector2d;

constexpr int rays_at_most = 1 << 17;     // of the whole pupil
constexpr int rays_at_least = 1 << 12;    // of a part
constexpr double rays_per_pixel = 128.0;  // of a kernel, so that its density shows no noise

/// A ray through the pupil, in pixels to the right and down.
struct PupilRay {
  Vector2d per_dioptre;  ///< where it moves with the vergence
  Vector2d at_rest;      ///< where it lands of a point at infinity
  double weight;         ///< of Stiles and Crawford
};

/// Roberts' additive sequence: any first part of it fills the square evenly.
Vector2d even_point(int i) {
  constexpr double plastic = 1.32471795724474602596;
  const double x = 0.5 + (i + 1) / plastic, y = 0.5 + (i + 1) / (plastic * plastic);
  return {x - std::floor(x), y - std::floor(y)};
}

class PartRays {
 public:
  PartRays(const Eye& eye, double accommodation_D, double pixel_slope, const PupilSector& sector, int count) {
    const double a = eye.pupil_radius_m;
    rays_.resize(a > 0.0 ? static_cast<std::size_t>(count) : 1);
    tbb::parallel_for(std::size_t{0}, rays_.size(), [&](std::size_t i) {
      const Vector2d u = even_point(static_cast<int>(i));
      const double r = a * std::sqrt(std::lerp(sector.inner, sector.outer, u.x())),
                   angle = 2.0 * std::numbers::pi * std::lerp(sector.from, sector.to, u.y());
      const Vector2d p(r * std::cos(angle), r * std::sin(angle));
      const Vector2d slope = (eye.wavefront ? eye.wavefront->slope(p) : eye.correction.slope(p)) - accommodation_D * p;
      rays_[i] = {on_picture(p, pixel_slope), on_picture(slope, pixel_slope),
                  std::pow(10.0, -eye.stiles_crawford_per_m2 * r * r)};
    });
  }

  /// Of all rays, in rays that count fully.
  double light() const {
    double sum = 0.0;
    for (const PupilRay& ray : rays_) sum += ray.weight;
    return sum / static_cast<double>(rays_.size());
  }

  Vector2d shift_per_dioptre() const {
    Vector2d sum = Vector2d::Zero();
    for (const PupilRay& ray : rays_) sum += ray.weight * ray.per_dioptre;
    return sum / (light() * static_cast<double>(rays_.size()));
  }

  SpreadKernel kernel(double vergence_D) const {
    std::vector<LandedRay> landed(static_cast<std::size_t>(count_for(vergence_D)));
    for (std::size_t i = 0; i < landed.size(); ++i)
      landed[i] = {rays_[i].at_rest + vergence_D * rays_[i].per_dioptre, rays_[i].weight};
    return deposited(landed, largest_kernel_radius_px);
  }

 private:
  /// A point lies opposite to where the ray leaves the eye; rows of a picture go down.
  static Vector2d on_picture(const Vector2d& slope, double pixel_slope) {
    return Vector2d(-slope.x(), slope.y()) / pixel_slope;
  }

  std::ptrdiff_t count_for(double vergence_D) const {
    const auto all = static_cast<std::ptrdiff_t>(rays_.size());
    Vector2d low = rays_[0].at_rest + vergence_D * rays_[0].per_dioptre, high = low;
    for (std::size_t i = 0; i < std::min<std::size_t>(rays_.size(), 64); ++i) {
      const Vector2d at = rays_[i].at_rest + vergence_D * rays_[i].per_dioptre;
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    const double wanted = rays_per_pixel * ((high - low).array() + 1.0).prod();
    return std::min<std::ptrdiff_t>(
        all, std::max<std::ptrdiff_t>(rays_at_least, static_cast<std::ptrdiff_t>(std::min(wanted, 1e9))));
  }

  std::vector<PupilRay> rays_;
};

}  // namespace

KernelModel ray_kernels(const Eye& eye, double accommodation_D, double pixel_slope, const RayKernelSettings& settings) {
  if (!(pixel_slope > 0.0)) throw std::invalid_argument("a pixel has a size");
  auto parts = std::make_shared<std::vector<PartRays>>();
  KernelModel model;
  double light = 0.0;
  for (const PupilSector& sector : pupil_sectors(settings.parts)) {
    parts->emplace_back(eye, accommodation_D, pixel_slope, sector,
                        std::max(rays_at_least, rays_at_most / settings.parts));
    model.parts.push_back({parts->back().light(), parts->back().shift_per_dioptre()});
    light += model.parts.back().weight;
  }
  for (PupilPart& part : model.parts) part.weight /= light;
  model.channels = settings.chromatic ? 3 : 1;
  model.reach_px_per_D = eye.pupil_radius_m / pixel_slope;
  model.kernel = [parts, chromatic = settings.chromatic](double vergence_D, int part, int channel) {
    const double added_D = chromatic ? chromatic_vergence_D(primary_wavelengths_nm[channel], focus_wavelength_nm) : 0.0;
    return (*parts)[part].kernel(vergence_D + added_D);
  };
  return model;
}

}  // namespace sturm
