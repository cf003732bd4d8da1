#pragma once
#include <filesystem>
#include <string>

#include "stages/page/page_data.h"

namespace sturm {

/// The viewer's page without data: `given`, or where the program finds it beside itself, in the build tree
/// (viewer/viewer.html beside the preset's folder) or installed (share/sturm/viewer/viewer.html). Throws InputError for
/// a file that is not there or is no such page, and where it was not built.
std::string view_template(const std::string& given);

/// The page with its data (docs/formats/viewer_scene.md).
std::string filled_page(std::string page, const PageData& data);

}  // namespace sturm
