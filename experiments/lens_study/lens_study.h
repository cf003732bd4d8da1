#pragma once
#include "compare/studies/lens/lens_findings.h"
#include "experiments/run/mutations.h"
#include "io/specs/experiment/lens_study_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// One lens of the accuracy study: its share of the section "lens_study" of the report. Gazes are traced in parallel;
/// the result does not depend on the number of threads.
LensPart lens_study_of(const LensStudySpec& spec, const StudyLens& lens, const ProgressFunction& progress);

/// The ellipses of all methods over the wide field.
LensField wide_gaze_study(const LensStudySpec& spec, const WideGaze& gaze);

LensStudyConditions conditions_of(const LensStudySpec& spec);

/// Footprints that are wrong on purpose: their orders of convergence are part of the findings.
std::span<const OwnMutation> lens_study_mutations();

/// What would have been found with the error of this id.
LensFindings mutated_lens_study(LensFindings found, const std::string& mutation);

/// The measured facts about conoid tracing in one sentence; null without views.
Json lens_study_sentence(const LensFindings& found);

}  // namespace sturm
