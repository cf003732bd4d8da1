#pragma once
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// Whether a picture has anything that `take_lamps` may find.
bool may_have_lamps(const LayeredPicture& picture);

/// Takes the lamps out of a picture with its hidden pixels, into `picture.lamps`. A lamp is what is 20 times as bright
/// as the picture's median, and as what lies about it on its surface, which goes on smoothly in its place; and what is
/// beside one and brighter than all of the surface about it. So lamps do not reach where a background is guessed. A
/// pixel that a lamp fills in part has its light where its neighbours are bright. Where the rim of a surface holds the
/// light of a lamp on another one, the light gets that one's distance.
void take_lamps(LayeredPicture& picture);

}  // namespace sturm
