#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "pathtrace/guide/guided_target.h"
#include "pathtrace/guide/pupil_region.h"
#include "pathtrace/guide/view_conoid.h"
#include "pathtrace/lights/emitter_clusters.h"

namespace sturm {

/// EmitterGuide for a GeneralCamera: through spectacles, with any spread of points over the pupil, over the whole
/// sphere, with an eye that turns and accommodates. The chief ray of each sample's film place is refracted as it is;
/// about it the map from the pupil to the emitter's plane is taken as affine (ViewConoidField), and the rectangle holds
/// what the affine map leaves out as far as it is known: the spectacles' aberrations and those of the eye, so that all
/// pupil points that see one emitter lie in it, were there several. The density is that of the rectangle, known
/// exactly, whatever the true map does; no ray has to be aimed and no Jacobian is needed. It is a PupilGuide.
class ViewGuide {
 public:
  using Camera = GeneralCamera;

  ViewGuide(const Scene& scene, const GeneralCamera& camera);

  bool empty() const { return use_ != GuideUse::in_use; }
  GuideUse use() const { return use_; }
  const Scene& scene() const { return scene_; }
  const GeneralCamera& camera() const { return camera_; }
  const EmitterClusters& clusters() const { return clusters_; }

  /// A place of the picture [px] as the guide sees it.
  struct Place {
    GeneralCamera::Place camera;
    LightRay chief;                      ///< as it leaves the eye or the spectacles, head frame
    Eigen::Matrix<double, 2, 3> across;  ///< its axes
    ViewConoid conoid;
    Eigen::Matrix2d slope_matrix;  ///< S of the eye as it is accommodated there
  };

  void find_targets(const GeneralCamera::Pixel& pixel, std::vector<GuidedTarget>& targets) const;

  /// None where the chief ray is lost.
  std::optional<Place> place(const GeneralCamera::Pixel& pixel, const GeneralCamera::FilmPlace& film) const;
  std::optional<PupilRegion> region(int cluster, const Place& place) const;
  std::optional<CameraRay> ray(const Place& place, const Eigen::Vector2f& point) const;
  float plain_weight(const Eigen::Vector2f& point) const;
  float share_of_plain(float guided_pdf, const Eigen::Vector2f& point) const;

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
  const GeneralCamera& camera_;
  double radius_;
  EmitterClusters clusters_;
  PupilSlopes slopes_;
  GuideUse use_ = GuideUse::in_use;
  std::optional<ViewConoidField> conoids_;  ///< only where in use
};

}  // namespace sturm
