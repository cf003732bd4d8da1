#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "pathtrace/cameras/eye_camera.h"
#include "pathtrace/guide/guided_target.h"
#include "pathtrace/guide/pupil_region.h"
#include "pathtrace/lights/emitter_clusters.h"

namespace sturm {

/// Where in the pupil a pixel of an EyeCamera sees small bright emitters, from the conoid: the ray of pupil point p and
/// chief slope q passes an emitter at the planar distance d at x = d q + X p, X = I + d·S, so the points that see it
/// are X⁻¹(emitter − d q). Plain lens sampling finds them by luck; a guided sample goes there.
///
/// One guided sample chooses an emitter with probability P (for the pixel as a whole), a chief slope within the pixel
/// and a pupil point uniformly in a rectangle on the singular directions of X that holds all points which see the
/// emitter's bounding sphere. Where X is singular (at a focal line) the rectangle is a strip across the pupil, where X
/// vanishes the whole pupil: nothing is divided by zero. A wrong S would only cost efficiency: the estimate is right
/// with any density that is known. It is a PupilGuide.
class EmitterGuide {
 public:
  using Camera = EyeCamera;

  /// Guides to emitters that are seen from less than nine tenths of the pupil at a time; larger ones are left to plain
  /// sampling. The conoid's S is that of the power matrix.
  EmitterGuide(const Scene& scene, const EyeCamera& camera);

  GuideUse use() const;
  bool empty() const { return lenses_.empty(); }
  const Scene& scene() const { return scene_; }
  const EyeCamera& camera() const { return camera_; }
  const EmitterClusters& clusters() const { return clusters_; }

  /// A film place and its chief slope [rad].
  struct Place {
    EyeCamera::Pixel pixel;
    EyeCamera::FilmPlace film;
    float qx, qy;
  };

  /// None in pixels without points over the pupil, where there is nothing to guide.
  void find_targets(const EyeCamera::Pixel& pixel, std::vector<GuidedTarget>& targets) const;
  std::optional<Place> place(const EyeCamera::Pixel& pixel, const EyeCamera::FilmPlace& film) const {
    return Place{pixel, film, camera_.slope_x(film.x()), camera_.slope_y(film.y())};
  }
  std::optional<PupilRegion> region(int cluster, const Place& place) const;
  std::optional<CameraRay> ray(const Place& place, const Eigen::Vector2f& point) const;
  float plain_weight(const Eigen::Vector2f&) const { return 1.0f; }
  float share_of_plain(float guided_pdf, const Eigen::Vector2f&) const {
    return plain_pdf_ / (plain_pdf_ + guided_pdf);
  }

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

  const Scene& scene_;
  const EyeCamera& camera_;
  EmitterClusters clusters_;
  float radius_;
  float plain_pdf_;  ///< the same all over the pupil [1/m²]
  std::vector<Lens> lenses_;
  std::vector<int> lens_of_cluster_;  ///< −1: not guided
};

}  // namespace sturm
