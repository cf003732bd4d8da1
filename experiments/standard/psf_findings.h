#pragma once
#include <filesystem>
#include <span>
#include <vector>

#include "compare/findings/psfs.h"
#include "experiments/run/mutations.h"
#include "io/specs/experiment/experiment_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// Image of a point-like emitter for each ray model of one PSF experiment, and what mutated predictors would have
/// found. Pictures go into `folder`.
std::vector<PsfFinding> psf_findings(const PsfExperiment& spec, std::uint64_t seed, std::span<const Mutation> mutations,
                                     const std::filesystem::path& folder, const ProgressFunction& progress);

}  // namespace sturm
