#pragma once
#include "reports/sections/sections.h"

namespace sturm {

/// The section "toy_study" of the page; nothing without it.
Html toy_study_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload);

}  // namespace sturm
