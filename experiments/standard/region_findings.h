#pragma once
#include <filesystem>
#include <span>

#include "compare/findings/pictures.h"
#include "experiments/run/mutations.h"
#include "io/specs/experiment/picture_experiment.h"
#include "pathtrace/scene/scene_description.h"
#include "stages/render_stage.h"

namespace sturm {

/// One view path traced and predicted in several ways, with times and errors by region. Mutations are put into point
/// spreads over depth by rays. Pictures go into `folder`.
PictureFinding region_finding(const PictureExperiment& spec, const SceneDescription& description, std::uint64_t seed,
                              std::span<const Mutation> mutations, const std::filesystem::path& folder,
                              const ProgressFunction& progress);

}  // namespace sturm
