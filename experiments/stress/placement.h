#pragma once
#include "experiments/stress/extended.h"
#include "lensmodel/spectacles.h"

namespace sturm::stress {

/// Where one surface of a lens stands before the eye, in extended precision: turns of the coordinates one after the
/// other by the angles that the mounting states. The matrices of `Mounting` are not read.
class Placement {
 public:
  enum class Side { back, front };
  Placement(const Spectacles& lens, Side side)
      : vertex_{lens.mounting.decentration_m().x(), lens.mounting.decentration_m().y(),
                -static_cast<Extended>(lens.vertex_distance_m)},
        depth_(side == Side::front ? static_cast<Extended>(lens.center_thickness_m) : 0.0L),
        tilt_(lens.mounting.pantoscopic_tilt()),
        wrap_(lens.mounting.wrap()) {
    const Extended gx = lens.mounting.wedge().x(), gy = lens.mounting.wedge().y(), slope = std::hypot(gx, gy);
    if (side == Side::front || slope == 0.0L) return;
    wedge_ = Turn(std::atan(slope));
    heading_x_ = gx / slope;
    heading_y_ = gy / slope;
  }

  template <class T>
  Vec3<T> direction_on_surface(Vec3<T> v) const {
    wrap_.turn(v.x, v.z, -1);
    tilt_.turn(v.y, v.z, 1);
    turn_by_wedge(v, -1);
    return v;
  }
  template <class T>
  Vec3<T> direction_before_eye(Vec3<T> v) const {
    turn_by_wedge(v, 1);
    tilt_.turn(v.y, v.z, -1);
    wrap_.turn(v.x, v.z, 1);
    return v;
  }
  template <class T>
  Vec3<T> point_on_surface(const Vec3<T>& p) const {
    Vec3<T> v = direction_on_surface(Vec3<T>{p.x - T(vertex_.x), p.y - T(vertex_.y), p.z - T(vertex_.z)});
    v.z = v.z + T(depth_);
    return v;
  }
  template <class T>
  Vec3<T> point_before_eye(Vec3<T> p) const {
    p.z = p.z - T(depth_);  // no wedge where there is a depth
    p = direction_before_eye(p);
    return {p.x + T(vertex_.x), p.y + T(vertex_.y), p.z + T(vertex_.z)};
  }

 private:
  /// In a plane: (a, b) becomes (a cos − b sin, a sin + b cos) for the way 1, the inverse for −1.
  struct Turn {
    Extended sine = 0.0L, cosine = 1.0L;
    Turn() = default;
    explicit Turn(Extended angle) : sine(std::sin(angle)), cosine(std::cos(angle)) {}

    template <class T>
    void turn(T& a, T& b, int way) const {
      if (sine == 0.0L) return;
      const Extended s = static_cast<Extended>(way) * sine;
      const T turned = cosine * a - s * b;
      b = s * a + cosine * b;
      a = turned;
    }
  };

  /// About the axis across the heading, so that the surface rises towards it.
  template <class T>
  void turn_by_wedge(Vec3<T>& v, int way) const {
    if (wedge_.sine == 0.0L) return;
    T along = heading_x_ * v.x + heading_y_ * v.y;
    const T before = along;
    wedge_.turn(along, v.z, way);
    v.x = v.x + heading_x_ * (along - before);
    v.y = v.y + heading_y_ * (along - before);
  }

  Vec3<Extended> vertex_;  // of the back
  Extended depth_;         // of this surface's vertex behind it
  Turn tilt_, wrap_, wedge_;
  Extended heading_x_ = 0.0L, heading_y_ = 0.0L;
};

}  // namespace sturm::stress
