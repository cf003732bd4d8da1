#pragma once
#include <filesystem>

#include "io/json/json.h"

namespace sturm::test {

/// A report as a run would write it ("sturm.report/1"): ellipses from the formulas of
/// docs/theory.md#4-the-footprint-of-the-pupil and docs/theory.md#61-second-moments-in-closed-form, with reproducible
/// scatter where a run measures. With `failing` two gates are not met.
Json synthetic_report(bool failing = false);

/// The EXR files that the report names: point-spread functions made of 2·10⁵ rays, and a small scene with noise.
void write_synthetic_pictures(const Json& report, const std::filesystem::path& run_folder);

}  // namespace sturm::test
