#pragma once
#include <string_view>

#include "io/specs/lens_files/lens_file.h"

namespace sturm {

/// The lens of a job in the Vision Council's Data Communication Standard (VCA, OMA). docs/formats/lens_files.md. Throws
/// InputError.
LensFile vca_lens(std::string_view text, const LensFileRequest& request);

}  // namespace sturm
