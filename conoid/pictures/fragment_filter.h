#pragma once
#include "io/images/fragment_image.h"

namespace sturm {

/// Direct light has edges of shadows and little noise beside them; indirect light has noise everywhere and hardly any
/// edge.
struct FilterSettings {
  int levels = 4;  ///< of the à-trous wavelet: the widest reaches 2·(2^levels − 1) pixels of the view
  double direct_tolerance = 2.5;    ///< differences of about so many standard errors still count as noise
  double indirect_tolerance = 4.0;  ///< the same for what comes by more than one reflection
};

/// The view with less noise: edge-avoiding à-trous wavelet filter [Dammertz2010] on what Lambertian fragments receive
/// (radiance divided by albedo, so that textures stay) and on the radiance of others, among those of about the same
/// albedo; direct and indirect light each by itself, guided by each fragment's plane and normal and by the variances of
/// both ends of a difference, so that rare bright samples keep their light. A fragment counts by its share of the
/// pixel. Lamps and the surroundings stay as they are. It trades noise for bias: gradients sharper than the noise
/// allows to see become softer. Variances are those of independent neighbours, as in [Schied2017]. The same bits for
/// any number of threads.
FragmentImage filtered(const FragmentImage& view, double pixel_slope, const Eigen::Vector3d& eye_position,
                       const FilterSettings& settings = {});

}  // namespace sturm
