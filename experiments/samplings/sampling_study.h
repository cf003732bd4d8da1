#pragma once
#include <filesystem>

#include "compare/studies/samplings/sampling_findings.h"
#include "io/specs/experiment/sampling_study_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// Configuration number `index` by every sampling and sampler, each against the uniform disc with Sobol' numbers of
/// other seeds, traced by the fast camera: its share of the entries of the report's section "sampling_study". Pictures
/// go into `folder`/samplings.
std::vector<SamplingEntry> sampling_entries(const SamplingStudySpec& study, std::size_t index, const Scene& scene,
                                            std::uint64_t seed, const std::filesystem::path& folder,
                                            const ProgressFunction& progress);

SamplingConditions conditions_of(const SamplingStudySpec& study);

}  // namespace sturm
