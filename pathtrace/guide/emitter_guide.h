#pragma once
#include <Eigen/Core>
#include <vector>

#include "pathtrace/cameras/camera.h"
#include "pathtrace/guide/guided_target.h"
#include "pathtrace/guide/pupil_rectangle.h"
#include "pathtrace/lights/emitter_clusters.h"

namespace sturm {

/// Where in the pupil a pixel sees small bright emitters, from the conoid: the ray of pupil point p and chief slope q
/// passes an emitter at the planar distance d at x = d q + X p, X = I + d·S, so the points that see it are X⁻¹(emitter
/// − d q). Plain lens sampling finds them by luck; a guided sample goes there.
///
/// One guided sample chooses an emitter with probability P (for the pixel as a whole), a chief slope within the pixel
/// and a pupil point uniformly in a rectangle on the singular directions of X that holds all points which see the
/// emitter's bounding sphere. Where X is singular (at a focal line) the rectangle is a strip across the pupil, where X
/// vanishes the whole pupil: nothing is divided by zero. A wrong S would only cost efficiency: the estimate is right
/// with any density that is known.
class EmitterGuide {
 public:
  /// A pupil point [m] and the density per area with which it was chosen; 0: outside of the pupil.
  struct Proposal {
    float px, py, pdf;
  };

  /// Emitters that are worth it: seen from less than `largest_share` of the pupil at a time. The conoid's S is that of
  /// the power matrix.
  EmitterGuide(const EmitterClusters& clusters, const EyeCamera& camera, float largest_share = 0.9f);

  bool empty() const { return lenses_.empty(); }

  /// The emitters that may be seen in pixel (x, y); their probabilities sum to 1.
  void find_targets(int x, int y, std::vector<GuidedTarget>& targets) const;

  /// From two uniform numbers, for chief slope (qx, qy).
  Proposal propose(int cluster, float qx, float qy, float u, float v) const;

  /// Density of `propose` at a pupil point.
  float pdf(int cluster, float qx, float qy, float px, float py) const;

  float pupil_radius() const { return radius_; }

 private:
  /// One cluster as the pupil sees it. X = U diag(σ) Vᵀ.
  struct Lens {
    int cluster;
    Eigen::Vector2f lateral;  ///< of its centre, across the line of sight [m]
    float distance;           ///< planar [m]
    float reach;              ///< half-width of the region across the line of sight that holds it [m]
    float farthest;  ///< across the line of sight: a chief ray that passes its centre farther off has no pupil point
                     ///< that sees it [m]
    float luminance;
    Eigen::Vector2f u1, u2, v1, v2, sigma;
  };

  PupilRectangle rectangle(const Lens& lens, float qx, float qy, float widening = 0.0f) const;
  const Lens& lens_of(int cluster) const {
    return lenses_[static_cast<std::size_t>(lens_of_cluster_[static_cast<std::size_t>(cluster)])];
  }

  const EyeCamera& camera_;
  float radius_;
  std::vector<Lens> lenses_;
  std::vector<int> lens_of_cluster_;  ///< −1: not guided
};

}  // namespace sturm
