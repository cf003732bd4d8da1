#pragma once
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// Smooths guessed colours of surfaces where these are hidden: each becomes the mean of its four neighbours on the same
/// surface, seen or guessed, so that no streaks lead away from the edge (a membrane, by successive over-relaxation).
/// Seen pixels beside the edge may hold some of the near surface's light; their unmixed neighbours stand for them.
void smooth_guesses(const LayeredPicture& picture, std::vector<HiddenPixel>& guesses);

}  // namespace sturm
