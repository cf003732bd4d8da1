#pragma once
#include <filesystem>

#include "io/json/json.h"

namespace sturm::test {

/// A report as a run would write it ("sturm.report/1"): ellipses from the formulas of physics.md §3 and §4.1, with
/// reproducible scatter where a run measures. With `failing` two gates are not met.
Json synthetic_report(bool failing = false);

/// The EXR files that the report names: point-spread functions made of 2·10⁵ rays, and a small scene with noise.
void write_synthetic_pictures(const Json& report, const std::filesystem::path& run_folder);

}  // namespace sturm::test
