#pragma once
#include <filesystem>

#include "io/json/json.h"
#include "io/specs/experiment/sampling_study_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// Configuration number `index` by every sampling and sampler, each against the uniform disc with Sobol' numbers of
/// other seeds, traced by the fast camera: its share of the entries of the report's section "sampling_study". Pictures
/// go into `folder`/samplings.
Json sampling_entries(const SamplingStudySpec& study, std::size_t index, const Scene& scene, std::uint64_t seed,
                      const std::filesystem::path& folder, const ProgressFunction& progress);

/// The section, put together from the entries of all configurations.
Json assembled_sampling_study(const SamplingStudySpec& study, const Json& entries);

}  // namespace sturm
