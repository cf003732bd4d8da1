#include "io/images/colour_primaries.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "io/files/formatted_text.h"

namespace sturm {

namespace {

constexpr double rounding = 5e-4;

/// XYZ of luminance 1.
Eigen::Vector3d xyz_of(const Eigen::Vector2d& xy) {
  return {xy.x() / xy.y(), 1.0, (1.0 - xy.x() - xy.y()) / xy.y()};
}

/// XYZ from RGB, so that (1, 1, 1) is the white of luminance 1.
Eigen::Matrix3d xyz_from(const ColourPrimaries& p) {
  for (const Eigen::Vector2d& xy : {p.red, p.green, p.blue, p.white})
    if (!xy.allFinite() || xy.norm() > 10.0) throw std::domain_error("chromaticities that are no numbers of colours");
  if (!(p.white.y() > 0.0)) throw std::domain_error("a white without luminance");
  Eigen::Matrix3d columns;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d& xy = i == 0 ? p.red : i == 1 ? p.green : p.blue;
    columns.col(i) = Eigen::Vector3d(xy.x(), xy.y(), 1.0 - xy.x() - xy.y());
  }
  if (!(std::abs(columns.determinant()) > 1e-6)) throw std::domain_error("primaries that span no colours");
  const Eigen::Vector3d amounts = columns.inverse() * xyz_of(p.white);
  if (!(amounts.minCoeff() > 0.0)) throw std::domain_error("a white that its primaries do not make");
  return columns * amounts.asDiagonal();
}

/// XYZ as it looks under the white D65, from XYZ under another white.
Eigen::Matrix3d bradford(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Eigen::Matrix3d cones;
  cones << 0.8951, 0.2664, -0.1614,  //
      -0.7502, 1.7135, 0.0367,       //
      0.0389, -0.0685, 1.0296;
  const Eigen::Vector3d gain = (cones * xyz_of(to)).cwiseQuotient(cones * xyz_of(from));
  return cones.inverse() * gain.asDiagonal() * cones;
}

}  // namespace

bool ColourPrimaries::is_rec709() const {
  const ColourPrimaries rec709;
  const auto near = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - b).cwiseAbs().maxCoeff() <= rounding;
  };
  return near(red, rec709.red) && near(green, rec709.green) && near(blue, rec709.blue) && near(white, rec709.white);
}

std::string ColourPrimaries::text() const {
  return formatted("R (%.4g, %.4g), G (%.4g, %.4g), B (%.4g, %.4g), white (%.4g, %.4g)", red.x(), red.y(), green.x(),
                   green.y(), blue.x(), blue.y(), white.x(), white.y());
}

Eigen::Matrix3d rec709_from(const ColourPrimaries& primaries) {
  const ColourPrimaries rec709;
  const Eigen::Matrix3d xyz = xyz_from(primaries);
  return xyz_from(rec709).inverse() * bradford(primaries.white, rec709.white) * xyz;
}

void transform_colours(Image& image, const Eigen::Matrix3d& matrix) {
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += static_cast<std::size_t>(image.channels)) {
    const Eigen::Vector3d colour = matrix * Eigen::Vector3d(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
    for (std::size_t c = 0; c < 3; ++c) image.pixels[i + c] = static_cast<float>(colour[static_cast<Eigen::Index>(c)]);
  }
}

}  // namespace sturm
