#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "pathtrace/guide/guided_target.h"
#include "pathtrace/guide/pupil_rectangle.h"
#include "pathtrace/guide/view_conoid.h"
#include "pathtrace/lights/emitter_clusters.h"

namespace sturm {

/// The pupil points that are proposed for one emitter at one place of the picture: uniform in a rectangle, cut to the
/// pupil.
struct PupilRegion {
  PupilRectangle rectangle{{0.0f, 0.0f}, {0.0f, 0.0f}};
  Eigen::Vector2f v1, v2;

  /// A pupil point [m] from two uniform numbers; it may lie outside of the pupil.
  Eigen::Vector2f point(float u, float v) const;

  /// Density of `point` [1/m²].
  float pdf(const Eigen::Vector2f& point) const;
};

/// EmitterGuide for a ViewCamera: through spectacles, with any spread of points over the pupil, over the whole sphere,
/// with an eye that turns and accommodates. The chief ray of each sample's film place is refracted as it is; about it
/// the map from the pupil to the emitter's plane is taken as affine (ViewConoidField), and the rectangle holds what the
/// affine map leaves out as far as it is known: the spectacles' aberrations and those of the eye, so that all pupil
/// points that see one emitter lie in it, were there several. The density is that of the rectangle, known exactly,
/// whatever the true map does; no ray has to be aimed and no Jacobian is needed.
class ViewGuide {
 public:
  ViewGuide(const Scene& scene, const ViewCamera& camera);

  bool empty() const { return use_ != GuideUse::in_use; }
  GuideUse use() const { return use_; }
  const Scene& scene() const { return scene_; }
  const ViewCamera& camera() const { return camera_; }
  const EmitterClusters& clusters() const { return clusters_; }

  /// A place of the picture [px] as the guide sees it.
  struct Place {
    ViewCamera::Place camera;
    LightRay chief;                      ///< as it leaves the eye or the spectacles, head frame
    Eigen::Matrix<double, 2, 3> across;  ///< its axes
    ViewConoid conoid;
    Eigen::Matrix2d slope_matrix;  ///< S of the eye as it is accommodated there
  };

  /// None where the chief ray is lost.
  std::optional<Place> place(double film_x, double film_y, const ViewCamera::Bundle& focus_bundle) const;

  /// The emitters that may be seen in pixel (x, y); their probabilities sum to 1.
  void find_targets(int x, int y, const ViewCamera::Bundle& focus_bundle, std::vector<GuidedTarget>& targets) const;

  /// None where no pupil point is expected to see the cluster.
  std::optional<PupilRegion> region(int cluster, const Place& place) const;

  /// How densely plain sampling spreads its points there [1/m²].
  float plain_pdf(const Eigen::Vector2f& point) const;

 private:
  /// One cluster seen along a chief ray: x = X p passes the plane at its distance, where it lies at `lateral`.
  struct Aspect {
    Eigen::Matrix2d x;
    Eigen::Vector2d lateral;
    double distance, reach;  ///< [m]
  };
  std::optional<Aspect> aspect(int cluster, const Place& place) const;
  PupilRegion region_of(const Aspect& aspect, const Eigen::Vector2d& lateral, double reach) const;
  std::optional<PupilRegion> region_within(const Aspect& aspect, double widening) const;
  bool worth_it(const Aspect& aspect) const;
  bool worth_it_somewhere() const;

  const Scene& scene_;
  const ViewCamera& camera_;
  double radius_;
  EmitterClusters clusters_;
  PupilSlopes slopes_;
  GuideUse use_ = GuideUse::in_use;
  std::optional<ViewConoidField> conoids_;  ///< only where in use
};

}  // namespace sturm
