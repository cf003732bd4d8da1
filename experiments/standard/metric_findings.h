#pragma once
#include <filesystem>
#include <span>
#include <vector>

#include "compare/findings/pictures.h"
#include "experiments/run/mutations.h"
#include "experiments/run/shared_views.h"
#include "io/specs/experiment/experiment_spec.h"

namespace sturm {

/// Picture number `index` of an experiment, measured by metrics: path traced with each ray model and predicted once. A
/// finding for each ray model, with what the mutations make of it. Pictures go into `folder`.
std::vector<PictureFinding> metric_findings(const ExperimentSpec& experiment, std::size_t index,
                                            const SceneDescription& description, SharedViews& views,
                                            std::span<const Mutation> mutations, const std::filesystem::path& folder,
                                            const ProgressFunction& progress);

}  // namespace sturm
