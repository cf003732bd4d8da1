#pragma once
#include <Eigen/Core>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "io/images/fragment_image.h"

namespace sturm {

/// A pixel-sized place of the world that a sharp view does not show: where it would be in the sharp view, and about how
/// far.
struct UnseenCell {
  static constexpr std::int32_t nowhere =
      std::numeric_limits<std::int32_t>::min();  ///< no chief ray goes there; x, y: of the picture
  static constexpr std::int32_t lamp = 1;
  static constexpr std::int32_t at_infinity = std::numeric_limits<std::int32_t>::max();
  std::int32_t x, y, depth;
  std::int32_t kind = 0;  ///< `lamp`; `nowhere`
  auto operator<=>(const UnseenCell&) const = default;

  std::uint64_t key() const;
  double distance() const;  ///< the middle of the cell's step of distance [m]
};

/// What a ray met, and where in the picture the chief ray to it is [px].
struct MetPoint {
  Eigen::Vector2d place;
  Eigen::Vector3f position;
  float distance;
  bool surroundings, emits;
};

/// Finds what a sharp view knows of a point. Keeps what that takes of each fragment: the view may go.
class SharpLookup {
 public:
  /// `pixel_slope`: of the picture, of which the view has `oversampling` pixels along each side. A ray that met a lamp
  /// finds fragments that emit alone. With `tell_lamps` no other ray finds these: a lamp and the ceiling around it
  /// share planes and pixels.
  SharpLookup(const FragmentImage& view, int oversampling, double pixel_slope, bool tell_lamps);

  /// Radiance of the fragment in the pixel of the point's place on whose plane it lies to a pixel's size; none if there
  /// is no such.
  std::optional<Eigen::Vector3f> find(const MetPoint& point) const;

  UnseenCell cell_of(const MetPoint& point) const;

 private:
  enum class Kind : std::uint32_t { surface, lamp, surroundings };
  struct Known {
    Eigen::Vector3f normal;
    float offset;  ///< of the plane from the world's origin [m]
    Eigen::Vector3f radiance;
    Kind kind;
  };

  static Kind kind_of(bool surroundings, bool emits) {
    return surroundings ? Kind::surroundings : emits ? Kind::lamp : Kind::surface;
  }
  Eigen::Vector2i pixel_of(const Eigen::Vector2d& place) const;

  int width_, height_, oversampling_;
  float pixel_slope_;
  bool tell_lamps_;
  std::vector<std::uint32_t> first_;  ///< of each pixel, row by row, and one more
  std::vector<Known> known_;
  std::vector<float> shares_;
};

}  // namespace sturm
