#pragma once
#include <vector>

#include "pathtrace/guide/pupil_guide.h"
#include "pathtrace/integrator/render_counters.h"

namespace sturm {

/// Guided samples of one pixel. What an emitter sends straight into the eye is estimated twice, by the plain samples
/// and by as many guided ones, with the balance heuristic (Veach & Guibas 1995): f/π_plain · π_plain/(π_plain +
/// π_guided) + f/π_guided · π_guided/(…). Both terms have the same bounded integrand f/(π_plain + π_guided); the sum is
/// unbiased wherever the map from the pupil to the emitter is singular. Lost rays bring nothing by either way of
/// sampling; where a guide knows no place there is no guided sample.
///
/// For EmitterGuide and ViewGuide.
template <PupilGuide Guide>
class GuidedPixel {
 public:
  GuidedPixel(const Guide& guide, int x, int y, const PixelSequence& sequence);

  bool active() const { return !targets_.empty(); }

  /// Weight of what light `emitter` sends straight into the eye along plain sample number `sample`.
  float plain_weight(int emitter, std::uint32_t sample) const;

  /// The guided sample of the same number.
  Eigen::Vector3f sample(std::uint32_t sample, RenderCounters& counters) const;

 private:
  const Guide& guide_;
  const PixelSequence& sequence_;
  typename Guide::Camera::Pixel pixel_;
  std::vector<GuidedTarget> targets_;
};

}  // namespace sturm
