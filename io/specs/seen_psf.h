#pragma once
#include "lensmodel/words.h"

namespace sturm {

/// What the kernels of a picture that is blurred by depth are made of.
enum class SeenPsf { Rays, Waves };

inline constexpr Words<SeenPsf, 2> seen_psf_words{{{SeenPsf::Rays, "rays"}, {SeenPsf::Waves, "waves"}}};  ///< words

}  // namespace sturm
