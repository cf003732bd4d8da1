#pragma once
#include <filesystem>

#include "compare/findings/reference.h"

namespace sturm {

/// The conoid and the closed form of sin² against independent numbers in the experiment's reference file. Throws
/// InputError.
ReferenceFinding reference_agreement(const std::filesystem::path& reference_file);

}  // namespace sturm
