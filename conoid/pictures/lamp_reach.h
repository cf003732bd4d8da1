#pragma once
#include "conoid/pictures/sight_field.h"
#include "io/images/fragment_image.h"
#include "io/images/image.h"

namespace sturm {

/// Whether the sharp pixels within `reach` of one, along rows and columns, have a lamp (a fragment that emits), and
/// something else as well.
bool at_lamp_rim(const FragmentImage& view, int x, int y, int reach = 1);

/// Where blur mixes a lamp with what is beside it: each pixel of the picture has the largest channel of the radiance of
/// the lamps whose rim (at_lamp_rim) is seen there through some point of the pupil, to 1.5 px; 0 where there is none.
/// One channel. An eye that accommodates everywhere is taken to look at the lamp; lamps outside of the view are not
/// known.
Image lamp_reach(const FragmentImage& view, int oversampling, const SightField& field);

}  // namespace sturm
