#pragma once
#include <filesystem>

#include "io/json/json.h"
#include "reports/markup/html.h"

namespace sturm {

/// The section "depth_psf_study" of the page: its tables, and the pictures of predictions whose layers were also
/// summed, beside their composition and the truth. Nothing where the report has neither.
Html depth_psf_section(const Json& report, const std::filesystem::path& run_folder);

}  // namespace sturm
