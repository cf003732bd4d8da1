#pragma once
#include <filesystem>

#include "compare/studies/sin2/sin2_findings.h"
#include "compare/studies/sin2/study_case.h"
#include "experiments/run/mutations.h"
#include "stages/render_stage.h"

namespace sturm {

/// All cases of one group of eyes: traced rays of each model against wavefront theory (the conoid) and against the
/// model's closed form. A list of rows (compare/studies/sin2/study_case.h). Eyes are traced in parallel; the result
/// does not depend on the number of threads.
Json sin2_study_rows(const Sin2StudySpec& spec, const StudyEyeGroup& group, const ProgressFunction& progress);

/// Point-spread functions of one gallery view by wavefront theory, sin², sin² with the tangential term and added focal
/// distances: their distances from the first, and their densities as EXR files in `folder`.
Sin2GalleryEntry sin2_gallery_entry(const Sin2StudySpec& spec, const Sin2GalleryView& view, std::uint64_t seed,
                                    const std::filesystem::path& folder);

/// Inputs that are wrong on purpose: what the checks say of them is part of the findings.
std::span<const OwnMutation> sin2_study_mutations();

/// What would have been found with the error of this id.
Sin2StudyFindings mutated_sin2_study(Sin2StudyFindings found, const std::string& mutation);

/// What the study measured, in one sentence; null without numbers.
Json sin2_study_sentence(const Sin2StudyFindings& found);

}  // namespace sturm
