#pragma once
#include "io/specs/prediction_spec.h"
#include "lensmodel/eye.h"
#include "stages/surfaces_picture.h"

namespace sturm {

/// What the layers of a sharp view give if each is blurred by the rays of its distance and all are added, without one
/// hiding another: the picture that point spreads over depth make without compositing. Surfaces that the view hides
/// have no part in it. `pixel_slope` is that of the picture, without oversampling; linear light.
Image sum_of_layers(const SurfacesPicture& surfaces, const Eye& eye, double pixel_slope,
                    const PredictionSpec& prediction);

}  // namespace sturm
