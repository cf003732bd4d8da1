#pragma once
#include "io/images/picture_format.h"

namespace sturm {

/// Whether a TIFF says that its colours are stored times alpha (ExtraSamples 1, in the first directory) [TIFF 6.0,
/// section 18]; of classic and of big files.
bool tiff_is_multiplied_by_alpha(const BytesAt& bytes_at);

}  // namespace sturm
