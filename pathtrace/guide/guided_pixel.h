#pragma once
#include <vector>

#include "pathtrace/guide/emitter_guide.h"
#include "pathtrace/integrator/render_counters.h"

namespace sturm {

/// The guide of one scene and one camera.
class SceneGuide {
 public:
  SceneGuide(const Scene& scene, const EyeCamera& camera)
      : scene_(scene), camera_(camera), clusters_(scene.lights()), guide_(clusters_, camera) {}

  bool empty() const { return guide_.empty(); }
  GuideUse use() const;
  const Scene& scene() const { return scene_; }
  const EyeCamera& camera() const { return camera_; }
  const EmitterClusters& clusters() const { return clusters_; }
  const EmitterGuide& guide() const { return guide_; }

 private:
  const Scene& scene_;
  const EyeCamera& camera_;
  EmitterClusters clusters_;
  EmitterGuide guide_;
};

/// Guided samples of one pixel. What an emitter sends straight into the eye is estimated twice, by the plain samples
/// and by as many guided ones, with the balance heuristic (Veach & Guibas 1995): f/π_plain · π_plain/(π_plain +
/// π_guided) + f/π_guided · π_guided/(…). Both terms have the same bounded integrand f/(π_plain + π_guided); the sum is
/// unbiased wherever X is singular.
class GuidedPixel {
 public:
  GuidedPixel(const SceneGuide& guide, int x, int y, const PixelSequence& sequence);

  bool active() const { return !targets_.empty(); }

  /// Weight of what light `emitter` sends straight into the eye along plain sample number `sample`.
  float plain_weight(int emitter, std::uint32_t sample) const;

  /// The guided sample of the same number.
  Eigen::Vector3f sample(std::uint32_t sample, RenderCounters& counters) const;

 private:
  /// π_plain/(π_plain + P g) at a pupil point.
  float share_of_plain(const GuidedTarget& target, float qx, float qy, float px, float py) const;

  const SceneGuide& guide_;
  int x_, y_;
  const PixelSequence& sequence_;
  float plain_pdf_;
  std::vector<GuidedTarget> targets_;
};

}  // namespace sturm
