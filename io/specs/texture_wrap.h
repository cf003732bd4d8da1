#pragma once
#include "lensmodel/words.h"

namespace sturm {

/// What a texture shows outside of coordinates from 0 to 1.
enum class TextureWrap { Clamp, Repeat, Mirror };

inline constexpr Words<TextureWrap, 3> texture_wrap_words{
    {{TextureWrap::Clamp, "clamp"}, {TextureWrap::Repeat, "repeat"}, {TextureWrap::Mirror, "mirror"}}};

}  // namespace sturm
