#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "io/images/image.h"
#include "pathtrace/lights/alias_table.h"

namespace sturm {

/// A direction towards the surroundings.
struct EnvironmentSample {
  Eigen::Vector3f direction;  ///< unit length
  Eigen::Vector3f radiance;
  float pdf;  ///< [1/sr]
};

/// Light from infinity out of a latitude–longitude picture, constant within each of its pixels.
///
/// The top row looks up (+y), the centre along −z, what is right of the centre lies towards +x. `rotation` [rad] turns
/// the surroundings to the right: the picture's centre is then seen at that azimuth. A pixel is chosen in proportion to
/// its luminance times its solid angle, first its row, then its column, and a point in it uniformly in solid angle: the
/// density is exactly that of a constant pixel.
class EnvironmentMap {
 public:
  /// `picture`: 3 channels, finite, not negative. `scale` multiplies it.
  EnvironmentMap(std::shared_ptr<const Image> picture, const Eigen::Vector3f& scale, float rotation);

  Eigen::Vector3f radiance(const Eigen::Vector3f& direction) const;  ///< any length but 0
  float pdf(const Eigen::Vector3f& direction) const;                 ///< density of sample(); any length but 0
  EnvironmentSample sample(float u, float v) const;

 private:
  struct Pixel {
    int x, y;
  };
  Pixel pixel(const Eigen::Vector3f& direction) const;
  Eigen::Vector3f radiance(Pixel at) const;
  float pdf(Pixel at) const;

  std::shared_ptr<const Image> picture_;
  Eigen::Vector3f scale_;
  float rotation_;
  AliasTable rows_;
  std::vector<AliasTable> columns_;
  std::vector<float> edge_cosine_;  // cos of the polar angle at the upper edge of each row, and −1
};

}  // namespace sturm
