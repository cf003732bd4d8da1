#pragma once
#include <filesystem>
#include <functional>

#include "experiments/run/mutations.h"
#include "experiments/run/shared_views.h"
#include "io/json/json.h"
#include "io/specs/experiment/experiment_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// Each section of a report is a function from the experiment to JSON (configs/schemas/report.schema.json); pictures go
/// into `folder`. What mutations make of an entry stands in it under "mutated" (experiments/run/mutated_entries.h).

/// Image number `index` of an experiment: one scene path traced with each ray model and predicted once: a list of
/// "images" entries.
Json image_entries(const ExperimentSpec& experiment, std::size_t index, const SceneDescription& description,
                   SharedViews& views, const std::filesystem::path& folder, const ProgressFunction& progress);

/// One view path traced and predicted in several ways, with times and errors by region: one entry of "agreement".
Json agreement_entry(const AgreementCase& spec, const SceneDescription& description, std::uint64_t seed,
                     const std::filesystem::path& folder, const ProgressFunction& progress);

}  // namespace sturm
