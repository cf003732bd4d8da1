#pragma once
#include "io/fragment_image.h"

namespace sturm {

struct FilterSettings {
  int levels = 4;               ///< of the à-trous wavelet: the widest reaches 2·(2^levels − 1) pixels of the view
  double direct_tolerance = 2.5, indirect_tolerance = 4.0;  ///< differences of about so many standard errors still count as noise
};

/// The view with less noise: edge-avoiding à-trous wavelet filter [Dammertz2010] on what Lambertian fragments receive (radiance divided by
/// albedo, so that textures stay), guided by each fragment's plane and normal and by its own variance as in [Schied2017]. Fragments that
/// emit, and those whose colour may change with the direction, stay as they are. It trades noise for bias: gradients sharper than the
/// noise allows to see become softer. The same bits for any number of threads.
FragmentImage filtered(const FragmentImage& view, double pixel_slope, const Eigen::Vector3d& eye_position,
                       const FilterSettings& settings = {});

}  // namespace sturm
