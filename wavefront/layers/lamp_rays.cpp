#include "wavefront/layers/lamp_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wavefront/layers/lamp_kernels.h"

namespace sturm {

namespace {

using Eigen::Vector2f;

constexpr std::size_t rays_of_all_lamps = std::size_t{1} << 23, fewest_rays = 512;

/// The places of a pixel that a lamp fills, from the pixel's middle.
std::vector<Vector2f> lit_places(const LampPixel& lamp) {
  std::vector<Vector2f> places;
  for (int place = 0; place < 16; ++place)
    if (lamp.places >> place & 1) places.push_back(middle_of_place(place).cast<float>());
  return places;
}

/// Between the middles of cells; nothing beyond the border.
float interpolated(const Image& coverage, const Vector2f& at) {
  const int left = static_cast<int>(std::floor(at.x())), above = static_cast<int>(std::floor(at.y()));
  const float f = at.x() - static_cast<float>(left), g = at.y() - static_cast<float>(above);
  const auto cell = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < coverage.width && y < coverage.height ? *coverage.at(x, y) : 0.0f;
  };
  return (1.0f - g) * ((1.0f - f) * cell(left, above) + f * cell(left + 1, above)) +
         g * ((1.0f - f) * cell(left, above + 1) + f * cell(left + 1, above + 1));
}

}  // namespace

LampRays::LampRays(const LayeredPicture& picture, const KernelBank& bank, const BlurPlan& plan)
    : picture_(picture),
      bank_(bank),
      side_(plan.side()),
      kept_(plan.kept()),
      rays_of_a_lamp_(std::max(fewest_rays, rays_of_all_lamps / std::max(std::size_t{1}, picture.lamps.size()))) {}

void LampRays::follow(const SplitWindow& window) {
  surfaces_.clear();
  followed_.clear();
  light_ = Image();
  if (picture_.lamps.empty() || bank_.rays().empty()) return;
  find_surfaces(window);
  for (int plane = 0; plane < planes(); ++plane)
    for (const LampEntry& entry : window.lamps_of(plane)) {
      const bool once = bank_.place_of(entry.lamp->vergence_D).plane == plane;  // it may be on two planes
      if (once && may_be_stopped(entry)) follow(entry);
    }
  std::sort(followed_.begin(), followed_.end());
}

bool LampRays::followed(const LampPixel& lamp) const {
  return std::binary_search(followed_.begin(), followed_.end(), &lamp);
}

void LampRays::find_surfaces(const SplitWindow& window) {
  double farthest_D = std::numeric_limits<double>::infinity();
  for (int plane = 0; plane < planes(); ++plane)
    for (const LampEntry& entry : window.lamps_of(plane)) farthest_D = std::min(farthest_D, entry.lamp->vergence_D);
  for (int plane = 0; plane < planes(); ++plane) {
    const std::span<const LayerEntry> entries = window.entries_of(plane);
    const double vergence_D = bank_.planes_D()[static_cast<std::size_t>(plane)];
    if (entries.empty() || !(vergence_D > farthest_D + picture_.jump_D)) continue;
    Surface surface{vergence_D, bank_.radius_px(plane), box_of(entries, side_), Image(side_, side_, 1)};
    for (const LayerEntry& entry : entries) surface.coverage.pixels[entry.cell] += entry.weight;
    surfaces_.push_back(std::move(surface));
  }
}

bool LampRays::may_be_stopped(const LampEntry& entry) const {
  const int x = static_cast<int>(entry.cell) % side_, y = static_cast<int>(entry.cell) / side_;
  return std::any_of(surfaces_.begin(), surfaces_.end(), [&](const Surface& surface) {
    const CellBox near = surface.box.grown(surface.radius_px + bank_.radius_at(entry.lamp->vergence_D) + 1);
    return lies_before(surface, *entry.lamp) && x >= near.left && x < near.right && y >= near.top && y < near.bottom;
  });
}

void LampRays::follow(const LampEntry& entry) {
  const LampPixel& lamp = *entry.lamp;
  followed_.push_back(&lamp);
  if (light_.pixels.empty()) light_ = Image(side_, side_, 3);
  const Vector2f cell(static_cast<float>(static_cast<int>(entry.cell) % side_),
                      static_cast<float>(static_cast<int>(entry.cell) / side_));
  const std::vector<Vector2f> places = lit_places(lamp);
  const auto vergence = static_cast<float>(lamp.vergence_D);
  for (std::size_t channel = 0; channel < bank_.rays().size(); ++channel) {
    const std::span<const PictureRay> rays(bank_.rays()[channel].data(),
                                           std::min(rays_of_a_lamp_, bank_.rays()[channel].size()));
    double weights = 0.0;
    for (const PictureRay& ray : rays) weights += ray.weight;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Vector2f landing = cell + places[i / bank_.parts().size() % places.size()] + rays[i].landing(vergence);
      const int x = static_cast<int>(std::floor(landing.x() + 0.5f)),
                y = static_cast<int>(std::floor(landing.y() + 0.5f));
      const bool is_kept = x >= kept_.left && y >= kept_.top && x < kept_.right && y < kept_.bottom;
      if (!is_kept || stopped(landing, rays[i], lamp)) continue;
      const auto share = static_cast<float>(rays[i].weight / weights);
      for (std::size_t c = 0; c < 3; ++c)
        if (bank_.rays().size() == 1 || c == channel) light_.at(x, y)[c] += share * lamp.rgb[c];
    }
  }
}

bool LampRays::stopped(const Vector2f& landing, const PictureRay& ray, const LampPixel& lamp) const {
  float covered = 0.0f;
  for (const Surface& surface : surfaces_)
    if (lies_before(surface, lamp))
      covered += interpolated(surface.coverage, landing - ray.landing(static_cast<float>(surface.vergence_D)));
  return covered > 0.5f;
}

}  // namespace sturm
