#pragma once
#include "conoid/pictures/sight_field.h"
#include "io/images/image.h"
#include "pathtrace/scene/scene.h"

namespace sturm {

/// What the chief ray of each pixel's centre meets, for telling regions of a picture apart. One channel each.
struct ViewLayers {
  Image depth;  ///< distance in units of the sight's direction [m]; ∞ where nothing is met or spectacles stop the ray
  Image blur_px;    ///< larger semi-axis of the blur ellipse there [px], by the conoid
  Image specular;   ///< 1 where the surface is not Lambertian: its colour changes with the direction
  Image lamp_rims;  ///< above 0 where blur mixes a lamp with what is beside it (conoid/pictures/lamp_reach.h)
};

ViewLayers view_layers(const Scene& scene, const SightField& field);

}  // namespace sturm
