#pragma once
#include <filesystem>

#include "compare/findings/pictures.h"
#include "io/specs/experiment/picture_experiment.h"
#include "pathtrace/scene/scene_description.h"
#include "stages/render_stage.h"

namespace sturm {

/// One view path traced and predicted in several ways, with times and errors by region. Pictures go into `folder`.
PictureFinding region_finding(const PictureExperiment& spec, const SceneDescription& description, std::uint64_t seed,
                              const std::filesystem::path& folder, const ProgressFunction& progress);

}  // namespace sturm
