#include "pathtrace/cameras/sharp_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lensmodel/symmetric2.h"

namespace sturm {

namespace {

using Polygon = std::vector<Eigen::Vector3d>;  // convex, eye frame: right, up, planar depth [m]

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Part of a convex polygon on one side of a plane of constant depth (Sutherland & Hodgman 1974).
Polygon clipped(const Polygon& polygon, double depth, bool keep_nearer) {
  Polygon part;
  const auto inside = [&](const Eigen::Vector3d& p) { return keep_nearer ? p.z() <= depth : p.z() >= depth; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    if (inside(from)) part.push_back(from);
    if (inside(from) == inside(to)) continue;
    Eigen::Vector3d crossing = from + (depth - from.z()) / (to.z() - from.z()) * (to - from);
    crossing.z() = depth;
    part.push_back(crossing);
  }
  return part;
}

/// Marks what convex bodies of one scene blur.
class Marking {
 public:
  Marking(const CameraPose& pose, const Eye& eye, double accommodation_D, const SharpVergences& sharp)
      : position_(pose.position),
        eye_from_world_(head_axes(pose).transpose()),
        center_(0.5 * pose.width, 0.5 * pose.height),
        pixel_slope_(pixel_slope(pose)),
        pupil_radius_(eye.pupil_radius_m),
        sharp_(sharp),
        cells_(pose.width, pose.height) {
    eye_from_world_.row(2) *= -1.0;
    const PowerMatrix s = eye.slope_matrix(accommodation_D);
    powers_ = principal_values(s.xx(), s.xy(), s.yy());
    largest_slope_ = center_.norm() * pixel_slope_;
  }

  Eigen::Vector3d in_eye_frame(const Eigen::Vector3f& world) const {
    return eye_from_world_ * (world.cast<double>() - position_);
  }

  /// A convex body, given by the faces of its hull; a triangle is its only face.
  void add(const std::vector<Polygon>& faces) {
    double nearest = infinity, farthest = -infinity;
    for (const Polygon& face : faces)
      for (const Eigen::Vector3d& p : face) {
        nearest = std::min(nearest, p.z());
        farthest = std::max(farthest, p.z());
      }
    if (!(farthest > 0.0)) return;  // rays go forwards
    if (sharp_.farthest > 0.0 && farthest > 1.0 / sharp_.farthest)
      blur_between(faces, std::max(nearest, 1.0 / sharp_.farthest), farthest);
    const double near_end = sharp_.nearest > 0.0 ? 1.0 / sharp_.nearest : infinity;
    if (nearest >= near_end) return;
    // Towards the eye the blur grows without bound: slabs of depth, each half as deep as the one before it.
    double high = std::min(near_end, farthest);
    for (int k = 0; k < slabs && high >= nearest; ++k, high *= 0.5)  // a face may have one depth
      blur_between(faces, std::max(0.5 * high, nearest), high);
    if (high > nearest) blur_at_the_pupil(faces, high);
  }

  const SharpCells& cells() const { return cells_; }

 private:
  static constexpr int slabs = 24;  // down to 6e-8 of the depth at which blur begins

  /// Largest blur at a depth, as a slope.
  double blur(double depth) const {
    const double vergence = 1.0 / depth;
    return pupil_radius_ * std::max(std::abs(vergence + powers_.high), std::abs(vergence + powers_.low));
  }

  /// Points of the body between two depths, 0 < low ≤ high: the corners of what the planes cut out of it.
  static Polygon between(const std::vector<Polygon>& faces, double low, double high) {
    Polygon points;
    for (const Polygon& face : faces) {
      const Polygon part = clipped(clipped(face, high, true), low, false);
      points.insert(points.end(), part.begin(), part.end());
    }
    return points;
  }

  /// The outline of a convex body is the hull of its corners' places; the blur is a norm of a matrix that is affine in
  /// the vergence: convex, so largest at an end.
  void blur_between(const std::vector<Polygon>& faces, double low, double high) {
    if (!(low > 0.0)) return blur_at_the_pupil(faces, high);
    Eigen::Vector2d least = Eigen::Vector2d::Constant(infinity), most = -least;
    for (const Eigen::Vector3d& p : between(faces, low, high)) {
      const Eigen::Vector2d slope = p.head<2>() / p.z(),
                            place = center_ + Eigen::Vector2d(slope.x(), -slope.y()) / pixel_slope_;
      least = least.cwiseMin(place);
      most = most.cwiseMax(place);
    }
    if (!(least.x() <= most.x())) return;
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(std::max(blur(low), blur(high)) / pixel_slope_);
    cells_.blur(least - reach, most + reach);
  }

  /// What lies between the pupil and the depth `high`, where no outline can be told: all cells are blurred if any ray
  /// of the picture can reach it at all.
  void blur_at_the_pupil(const std::vector<Polygon>& faces, double high) {
    const double slope = largest_slope_ + pupil_radius_ * std::max(std::abs(powers_.high), std::abs(powers_.low));
    const double reach = pupil_radius_ + high * slope;
    Eigen::Vector2d least = Eigen::Vector2d::Constant(infinity), most = -least;
    for (const Eigen::Vector3d& p : between(faces, 0.0, high)) {
      least = least.cwiseMin(p.head<2>());
      most = most.cwiseMax(p.head<2>());
    }
    if (least.x() <= reach && least.y() <= reach && most.x() >= -reach && most.y() >= -reach)
      cells_.blur({0.0, 0.0}, 2.0 * center_);
  }

  Eigen::Vector3d position_;
  Eigen::Matrix3d eye_from_world_;
  Eigen::Vector2d center_;
  double pixel_slope_, pupil_radius_, largest_slope_;
  PrincipalValues powers_;  // of S
  SharpVergences sharp_;
  SharpCells cells_;
};

/// The faces of a box with the given corners, x fastest, then y, then z.
std::vector<Polygon> box_faces(const std::array<Eigen::Vector3d, 8>& c) {
  return {{c[0], c[1], c[3], c[2]}, {c[4], c[5], c[7], c[6]}, {c[0], c[1], c[5], c[4]},
          {c[2], c[3], c[7], c[6]}, {c[0], c[2], c[6], c[4]}, {c[1], c[3], c[7], c[5]}};
}

/// The box low … high of the world, in the eye's frame.
std::vector<Polygon> world_box(const Marking& marking, const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  std::array<Eigen::Vector3d, 8> corners;
  for (unsigned k = 0; k < 8; ++k)
    corners[k] =
        marking.in_eye_frame({k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(), k & 4 ? high.z() : low.z()});
  return box_faces(corners);
}

}  // namespace

SharpVergences sharp_vergences(const Eye& eye, double accommodation_D, double largest_blur) {
  const PowerMatrix s = eye.slope_matrix(accommodation_D);
  const PrincipalValues powers = principal_values(s.xx(), s.xy(), s.yy());
  const double largest_V = eye.pupil_radius_m > 0.0 ? largest_blur / eye.pupil_radius_m : infinity;
  return {-powers.low - largest_V, -powers.high + largest_V};
}

SharpCells::SharpCells(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + cell_px - 1) / cell_px),
      rows_((height + cell_px - 1) / cell_px),
      left_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      sharp_(left_, 1) {}

std::uint64_t SharpCells::pixels() const {
  std::uint64_t sum = 0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
      if (at(column * cell_px, row * cell_px))
        sum += static_cast<std::uint64_t>(std::min(cell_px, width_ - column * cell_px)) *
               static_cast<std::uint64_t>(std::min(cell_px, height_ - row * cell_px));
  return sum;
}

void SharpCells::blur(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  const auto cell = [](double place_px, int count) {
    return static_cast<int>(std::clamp(std::floor(place_px / cell_px), -1.0, static_cast<double>(count)));
  };
  const int left = std::max(0, cell(low.x(), columns_)), right = std::min(columns_ - 1, cell(high.x(), columns_));
  const int top = std::max(0, cell(low.y(), rows_)), bottom = std::min(rows_ - 1, cell(high.y(), rows_));
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= right; ++column) {
      std::uint8_t& sharp =
          sharp_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
      left_ -= sharp;
      sharp = 0;
    }
}

std::shared_ptr<const SharpCells> sharp_cells(const SceneDescription& scene, const CameraPose& pose, const Eye& eye,
                                              double accommodation_D, double largest_blur_px) {
  if (!(eye.pupil_radius_m > 0.0)) return nullptr;  // nothing to bound: see the item zero_pupil
  const SharpVergences sharp = sharp_vergences(eye, accommodation_D, largest_blur_px * pixel_slope(pose));
  if (sharp.empty()) return nullptr;
  if (scene.environment && scene.environment->map && sharp.farthest > 0.0) return nullptr;
  Marking marking(pose, eye, accommodation_D, sharp);
  for (const Mesh& mesh : scene.meshes) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(mesh.positions.size());
    for (const Eigen::Vector3f& p : mesh.positions) points.push_back(marking.in_eye_frame(p));
    for (const auto& t : mesh.triangles) {
      if (!marking.cells().any()) return nullptr;
      marking.add({{points[t[0]], points[t[1]], points[t[2]]}});
    }
  }
  for (const Sphere& sphere : scene.spheres) {
    const Eigen::Vector3f half = Eigen::Vector3f::Constant(sphere.radius);
    marking.add(world_box(marking, sphere.center - half, sphere.center + half));
  }
  for (const Instance& instance : scene.instances) {
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity()), high = -low;
    for (const Eigen::Vector3f& p : scene.prototypes[static_cast<std::size_t>(instance.prototype)].positions) {
      const Eigen::Vector3f world =
          instance.world_from_prototype.leftCols<3>() * p + instance.world_from_prototype.col(3);
      low = low.cwiseMin(world);
      high = high.cwiseMax(world);
    }
    if (low.x() <= high.x()) marking.add(world_box(marking, low, high));
  }
  return marking.cells().any() ? std::make_shared<const SharpCells>(marking.cells()) : nullptr;
}

}  // namespace sturm
