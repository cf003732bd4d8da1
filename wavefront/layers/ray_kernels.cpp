#include "wavefront/layers/ray_kernels.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "lensmodel/chromatic_eye.h"
#include "wavefront/layers/primaries.h"
#include "wavefront/layers/pupil_parts.h"
#include "wavefront/layers/ray_deposit.h"
#include "wavefront/psf/ray_fan.h"

namespace sturm {

namespace {

using Eigen::Vector2d;

constexpr std::size_t rays_at_most = std::size_t{1} << 17;   // of the whole pupil
constexpr std::size_t rays_at_least = std::size_t{1} << 12;  // of a part
constexpr std::size_t single_rays = std::size_t{1} << 15;    // of the whole pupil, to be followed one by one
constexpr double rays_per_pixel = 128.0;                     // of a kernel, so that its density shows no noise

/// The rays of a part of the pupil on the pixels of a picture.
class PartRays {
 public:
  PartRays(const PupilWave& pupil, const PupilSector& sector, std::size_t count, double pixel_slope)
      : fan_(pupil, monochromatic_light(pupil.in_focus_nm), count, sector), pixel_slope_(pixel_slope) {}

  Vector2d shift_per_dioptre() const {
    Vector2d sum = Vector2d::Zero();
    for (std::size_t i = 0; i < fan_.points(); ++i) sum -= fan_.pupil_point(i);  // as a vergence moves its landing
    return on_picture(sum / static_cast<double>(fan_.points()));
  }

  SpreadKernel kernel(double vergence_D, const Vector2d& from, RayShare share) const {
    std::vector<LandedRay> landed;
    fan_.for_each(vergence_D, count_for(vergence_D), [&](const Vector2d& x, double weight) {
      landed.push_back({from + on_picture(x), weight});
    });
    return deposited(landed, largest_kernel_radius_px, share);
  }

  std::size_t count() const { return fan_.points(); }

  /// One of the rays, where the vergence error is that of the target and `more_D` besides.
  PictureRay ray(std::size_t i, double more_D, double weight) const {
    const Vector2d at_0_D = on_picture(fan_.landing(i, more_D)), at_1_D = on_picture(fan_.landing(i, more_D + 1.0));
    return {at_0_D.cast<float>(), (at_1_D - at_0_D).cast<float>(), static_cast<float>(weight)};
  }

 private:
  /// Rows of a picture go down.
  Vector2d on_picture(const Vector2d& landing) const { return Vector2d(landing.x(), -landing.y()) / pixel_slope_; }

  std::size_t count_for(double vergence_D) const {
    constexpr std::size_t some = 64;
    Vector2d low = on_picture(fan_.landing(0, vergence_D)), high = low;
    fan_.for_each(vergence_D, some, [&](const Vector2d& x, double) {
      low = low.cwiseMin(on_picture(x));
      high = high.cwiseMax(on_picture(x));
    });
    const double wanted = rays_per_pixel * ((high - low).array() + 1.0).prod();
    return wanted < static_cast<double>(fan_.points()) ? std::max(rays_at_least, static_cast<std::size_t>(wanted))
                                                       : fan_.points();
  }

  RayFan fan_;
  double pixel_slope_;
};

/// Rays of all parts in turn.
std::vector<PictureRay> single_rays_of(const std::vector<PartRays>& rays, const std::vector<PupilPart>& parts,
                                       double more_D) {
  std::vector<PictureRay> single;
  const std::size_t of_each = single_rays / parts.size();
  for (std::size_t i = 0; i < of_each; ++i)
    for (std::size_t part = 0; part < parts.size(); ++part)
      single.push_back(
          rays[part].ray(i % rays[part].count(), more_D, parts[part].weight / static_cast<double>(of_each)));
  return single;
}

/// The wave of an eye's pupil; a pinhole counts as one of no account.
PupilWave wave_of(Eye eye) {
  constexpr double smallest_radius_m = 1e-12;
  eye.pupil_radius_m = std::max(eye.pupil_radius_m, smallest_radius_m);
  return PupilWave::of(eye, focus_wavelength_nm);
}

}  // namespace

KernelModel ray_kernels(const Eye& eye, double accommodation_D, double pixel_slope, const RayKernelSettings& settings) {
  if (!(pixel_slope > 0.0)) throw std::invalid_argument("a pixel has a size");
  const PupilWave pupil = wave_of(eye);
  auto parts = std::make_shared<std::vector<PartRays>>();
  KernelModel model;
  const std::size_t count = std::max(rays_at_least, rays_at_most / static_cast<std::size_t>(settings.parts));
  for (const PupilSector& sector : pupil_sectors(settings.parts)) {
    parts->emplace_back(pupil, sector, count, pixel_slope);
    model.parts.push_back({pupil.share_of(sector), parts->back().shift_per_dioptre()});
  }
  model.channels = settings.chromatic ? 3 : 1;
  model.reach_px_per_D = eye.pupil_radius_m / pixel_slope;
  const auto error_D = [=, chromatic = settings.chromatic](double vergence_D, int channel) {
    return vergence_D - accommodation_D +
           (chromatic ? chromatic_vergence_D(primary_wavelengths_nm[channel], focus_wavelength_nm) : 0.0);
  };
  for (int channel = 0; channel < model.channels; ++channel)
    model.rays.push_back(single_rays_of(*parts, model.parts, error_D(0.0, channel)));
  model.kernel = [=](double vergence_D, int part, int channel) {
    return (*parts)[part].kernel(error_D(vergence_D, channel), Vector2d::Zero(), RayShare::FourPixels);
  };
  model.point_kernel = [=](double vergence_D, int part, int channel, const Vector2d& from) {
    return (*parts)[part].kernel(error_D(vergence_D, channel), from, RayShare::OnePixel);
  };
  return model;
}

}  // namespace sturm
