#pragma once
#include <span>
#include <vector>

#include "wavefront/layers/blur_plan.h"
#include "wavefront/layers/layer_split.h"

namespace sturm {

/// The light of lamps that nearer surfaces may stop. Coverage and light move together over the pupil, and a lamp is so
/// bright that the little which a part of the pupil lets through on average shows. So the rays of such lamps are
/// followed one by one: each is stopped where the nearer surfaces, interpolated between pixels, cover more than half of
/// the place that it comes past. For one tile after the other.
class LampRays {
 public:
  LampRays(const LayeredPicture& picture, const KernelBank& bank, const BlurPlan& plan);

  /// Follows the rays of the lamps of a window that lie behind something which is near enough to stop them.
  void follow(const SplitWindow& window);

  /// Whether the light of a lamp is among that of the window.
  bool followed(const LampPixel& lamp) const;
  int lamps() const { return static_cast<int>(followed_.size()); }

  /// What arrives in the window's cells: 3 channels; empty where no lamp was followed.
  const Image& light() const { return light_; }

 private:
  struct Surface {
    double vergence_D;
    int radius_px;
    CellBox box;
    Image coverage;
  };

  int planes() const { return static_cast<int>(bank_.planes_D().size()); }
  /// The surfaces that are nearer than the farthest lamp of a window.
  void find_surfaces(const SplitWindow& window);
  bool may_be_stopped(const LampEntry& entry) const;
  void follow(const LampEntry& entry);
  bool stopped(const Eigen::Vector2f& landing, const PictureRay& ray, const LampPixel& lamp) const;
  bool lies_before(const Surface& surface, const LampPixel& lamp) const {
    return surface.vergence_D > lamp.vergence_D + picture_.jump_D;
  }

  const LayeredPicture& picture_;
  const KernelBank& bank_;
  int side_;
  CellBox kept_;
  std::size_t rays_of_a_lamp_;
  std::vector<Surface> surfaces_;           // of one window, by plane
  std::vector<const LampPixel*> followed_;  // ascending
  Image light_;
};

}  // namespace sturm
