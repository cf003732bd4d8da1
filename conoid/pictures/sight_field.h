#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "io/specs/camera_spec.h"
#include "lensmodel/eye.h"
#include "lensmodel/light_ray.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// The plane of a perspective picture in the world. A place of the picture is (x, y) [px] from its upper left corner, y
/// down.
struct PicturePlane {
  Eigen::Vector3d position{0.0, 0.0, 0.0};                        ///< pupil centre in primary gaze [m]
  Eigen::Matrix3d world_from_head = Eigen::Matrix3d::Identity();  ///< axes right, up, back as columns
  int width = 0, height = 0;                                      ///< [px]
  double pixel_slope = 0.0;                                       ///< pixel pitch in tangent image coordinates
  Gaze gaze = Gaze::Camera;

  Eigen::Vector2d slope(const Eigen::Vector2d& place) const {
    return {(place.x() - 0.5 * width) * pixel_slope, (0.5 * height - place.y()) * pixel_slope};
  }
};

/// The rays that one place of the picture gathers, to first order in the pupil point p [m] and in the slope s with
/// which they leave the eye there: origin + offset_p p + offset_s s and direction + slope_p p + slope_s s (world). For
/// the naked eye in gaze `camera` this is exact and the direction's unit is a metre of planar distance; otherwise the
/// direction has unit length.
struct Sight {
  using Map = Eigen::Matrix<double, 3, 2>;
  bool reaches = false;  ///< false where spectacles stop the chief ray: the rest means nothing
  Eigen::Vector3d origin, direction;
  Map offset_p, offset_s, slope_p, slope_s;

  /// Of the slopes s = S p.
  Map offsets(const Eigen::Matrix2d& slopes) const { return offset_p + offset_s * slopes; }
  Map directions(const Eigen::Matrix2d& slopes) const { return slope_p + slope_s * slopes; }
};

/// The sight of one place with the chief slope `slope` (tangents to the right and up), traced through the spectacles
/// (null: naked eye). Of the plane, only its position, axes and gaze count.
Sight traced_sight(const PicturePlane& plane, const Eye& eye, const Spectacles* spectacles,
                   const Eigen::Vector2d& slope);

/// Sights over a picture: naked eye or spectacles (conoid tracing, docs/theory.md#81-sights-any-gaze-spectacles), gaze
/// `camera` or `foveal`. Naked eyes in closed form. Through spectacles, conoids stand on a grid of `grid_slope` (1.1°),
/// linear in between: chief rays are off by an eighth of its square times the second derivative of the deviation, 2e-5
/// rad where that is 0.4 rad⁻¹. Cells that a rim crosses, and places beyond the grid, are traced one by one.
///
/// In gaze `camera` the pupil is seen obliquely by the chief ray of slope q: its point p stands at the offset T p
/// across the ray, with the slope T s/√(1 + q²), where T keeps what is across. Immutable.
class SightField {
 public:
  static constexpr double grid_slope = 0.02;

  SightField(const PicturePlane& plane, const Eye& eye, std::optional<Spectacles> spectacles);

  const PicturePlane& plane() const { return plane_; }
  const Eye& eye() const { return eye_; }

  Sight at(const Eigen::Vector2d& place) const;

  /// Origin and direction of `at` alone; none where spectacles stop the chief ray.
  std::optional<LightRay> chief_ray(const Eigen::Vector2d& place) const;

  /// The place whose chief ray goes through a point [m], in closed form for the naked eye: the chief rays of a camera
  /// meet in its pupil, those of an eye that turns in its centre of rotation. None through spectacles, and for points
  /// that are not ahead.
  std::optional<Eigen::Vector2d> projected(const Eigen::Vector3d& point) const;
  bool projects() const { return !spectacles_; }

  /// S = F − A·I for an eye that looks at the distance 1/`vergence_D` along the sight (relaxed and fixed eyes do not
  /// care).
  Eigen::Matrix2d slopes(const Sight& sight, double vergence_D) const;

  /// Whether S depends on what the sight meets.
  bool seeks_focus() const { return std::holds_alternative<BestAccommodation>(eye_.accommodation); }

 private:
  Sight traced(const Eigen::Vector2d& place) const;
  void fill_grid();
  struct Cell {
    const Sight* corners[4];
    double weights[4];
  };
  std::optional<Cell> cell_of(const Eigen::Vector2d& place) const;

  PicturePlane plane_;
  Eye eye_;
  std::optional<Spectacles> spectacles_;
  double grid_px_ = 1.0;        ///< step of the grid [px]
  int columns_ = 0, rows_ = 0;  ///< of the grid, which begins one step outside of the picture
  std::vector<Sight> grid_;
};

/// How the picture turns about one place: derivatives of the chief ray by the place, and what follows from them.
class SightNeighbourhood {
 public:
  SightNeighbourhood(const SightField& field, const Eigen::Vector2d& place, const Sight& sight);

  const Sight::Map& origin_by_place() const { return origin_by_place_; }        ///< [m/px]
  const Sight::Map& direction_by_place() const { return direction_by_place_; }  ///< [1/px]

  /// Where in the picture [px, relative to its chief place] the pupil point p [m] sees a point at 1/`vergence_D`: M p,
  /// M = −G⁻¹ X with the footprint X and the displacement G of the chief ray per pixel there. The Jacobian of the
  /// projection is in G (docs/theory.md#81-sights-any-gaze-spectacles).
  Eigen::Matrix2d picture_map(const Eigen::Matrix2d& slopes, double vergence_D) const;

  /// The place whose chief ray goes through `point` [m], by Newton's iteration with the derivatives of here, to 0.002
  /// px. None where spectacles stop the chief rays on the way there.
  std::optional<Eigen::Vector2d> place_of(const Eigen::Vector3d& point) const;

 private:
  Eigen::Matrix2d displacement(double vergence_D) const { return vergence_D * across_origin_ + across_direction_; }

  const SightField& field_;
  Eigen::Vector2d place_;
  Sight sight_;
  Sight::Map origin_by_place_, direction_by_place_;
  Eigen::Matrix<double, 2, 3> across_;  // rows: a frame across the chief ray
  Eigen::Matrix2d across_origin_, across_direction_;
};

}  // namespace sturm
