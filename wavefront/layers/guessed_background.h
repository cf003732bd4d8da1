#pragma once
#include <span>

#include "wavefront/layers/kernel_bank.h"
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// Adds to what is hidden a guess where nothing is known of it: far surfaces continued smoothly under the edges of
/// nearer ones, as far as the blur of the bank can show it (io/images/disocclusion.h). Returns the number of pixels
/// that were guessed.
long long add_guessed_background(LayeredPicture& picture, const KernelBank& bank);

/// The same where the picture's edges are known already: `edges` is `edges_of` it.
long long add_guessed_background(LayeredPicture& picture, const KernelBank& bank, std::span<const std::size_t> edges);

}  // namespace sturm
