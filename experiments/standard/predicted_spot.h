#pragma once
#include <Eigen/Core>

#include "io/images/image.h"

namespace sturm {

/// The picture of a small round light of radiance 1 in the middle of a black square view, as a conoid's footprint
/// predicts it: the light spread over the ellipse, each pixel by exact area. A pixel's value is the share of the pupil
/// through which it sees the light, averaged over the pixel. `map` takes the unit disc to image offsets [px], x to the
/// right and y up; it may be singular (a focal line) or zero. Three equal channels. The sum over all pixels is the
/// light's area [px²], π·radius², where the ellipse lies within the picture.
Image predicted_spot(const Eigen::Matrix2d& map, double light_radius_px, int resolution);

}  // namespace sturm
