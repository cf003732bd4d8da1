#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sturm {

/// A piece of one surface as a pixel of a sharp view sees it: the means over the samples that met it.
struct Fragment {
  Eigen::Vector3f position;  ///< [m], world; of the surroundings the direction, unit length
  Eigen::Vector3f normal;    ///< unit length; of the surroundings zero
  Eigen::Vector3f radiance;  ///< linear, towards the pupil's centre
  Eigen::Vector3f
      direct;  ///< the part of it that the surface emits, or that comes from lights and surroundings by one reflection
  Eigen::Vector3f albedo;  ///< of the surface's Lambertian part, if it has one
  Eigen::Vector3f
      direct_variance;  ///< of the mean `direct`, from the scatter of its samples (low-discrepancy samples do better)
  Eigen::Vector3f indirect_variance;   ///< the same of the rest
  float share = 0.0f;                  ///< of the pixel's samples
  Eigen::Vector2f middle{0.5f, 0.5f};  ///< of these samples within the pixel, (0, 1)² from its upper left corner
  Eigen::Vector3f spread{1.0f / 12, 0.0f, 1.0f / 12};  ///< xx, xy, yy: their covariance there
  bool surroundings = false;
  bool lambertian = false;  ///< its colour does not change with the direction
  bool emits = false;       ///< some of it is seen from a side that emits
};

/// A sharp view with a short list of fragments instead of one colour per pixel (A-buffer, Carpenter 1984): what lies
/// behind an edge does not mix with what lies before it. Pixels whose chief rays spectacles stop have none.
struct FragmentImage {
  int width = 0, height = 0;
  std::vector<std::uint32_t> first;  ///< of each pixel, row by row, and one more: width × height + 1
  std::vector<Fragment> fragments;

  std::span<const Fragment> at(int x, int y) const {
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    return {fragments.data() + first[pixel], fragments.data() + first[pixel + 1]};
  }
};

}  // namespace sturm
