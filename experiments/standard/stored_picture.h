#pragma once
#include <filesystem>
#include <string>

#include "compare/findings/pictures.h"
#include "io/images/image.h"

namespace sturm {

inline constexpr double metrics_exposure = 1.0;  ///< of the display space of metrics and PNG files

/// Writes images/NAME.exr and images/NAME.png into the run folder.
PictureFiles stored_picture(const std::filesystem::path& run_folder, const std::string& name, const Image& linear);

}  // namespace sturm
