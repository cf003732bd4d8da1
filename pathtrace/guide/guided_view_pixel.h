#pragma once
#include <vector>

#include "pathtrace/guide/view_guide.h"
#include "pathtrace/integrator/render_counters.h"

namespace sturm {

/// Guided samples of one pixel of a ViewCamera; as GuidedPixel, with the density and the weights of the camera's own
/// spread of points. Lost rays bring nothing by either way of sampling; where the chief ray is lost there is no guided
/// sample.
class GuidedViewPixel {
 public:
  GuidedViewPixel(const ViewGuide& guide, int x, int y, const PixelSequence& sequence);

  bool active() const { return !targets_.empty(); }

  /// Weight of what light `emitter` sends straight into the eye along plain sample number `sample`.
  float plain_weight(int emitter, std::uint32_t sample) const;

  /// The guided sample of the same number.
  Eigen::Vector3f sample(std::uint32_t sample, RenderCounters& counters) const;

 private:
  /// π_plain/(π_plain + P g) at a pupil point that is proposed with the density g.
  float share_of_plain(const GuidedTarget& target, float proposed_pdf, const Eigen::Vector2f& point) const;

  const ViewGuide& guide_;
  int x_, y_;
  const PixelSequence& sequence_;
  ViewCamera::Bundle focus_bundle_;
  std::vector<GuidedTarget> targets_;
};

}  // namespace sturm
