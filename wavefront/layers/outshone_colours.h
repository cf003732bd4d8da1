#pragma once
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// Colours of a picture's surfaces where lamps outshine them: what the nearest pixels on either side tell that are no
/// lamps, along rows and columns, by a cubic through two of each side, or a line through one. What fits together more
/// closely counts more, so that a stripe goes on through a lamp, whichever way it runs. A pixel that lies between no
/// two others of its surface keeps its colour. `outshone`: pixels of `picture`, each one once.
void guess_outshone(const LayeredPicture& picture, std::vector<HiddenPixel>& outshone);

}  // namespace sturm
