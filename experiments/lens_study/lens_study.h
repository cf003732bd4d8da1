#pragma once
#include "compare/studies/lens/lens_findings.h"
#include "io/specs/experiment/lens_study_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// One lens of the accuracy study: its share of the section "lens_study" of the report. Gazes are traced in parallel;
/// the result does not depend on the number of threads.
LensPart lens_study_of(const LensStudySpec& spec, const StudyLens& lens, const ProgressFunction& progress);

/// The ellipses of all methods over the wide field.
LensField wide_gaze_study(const LensStudySpec& spec, const WideGaze& gaze);

LensStudyConditions conditions_of(const LensStudySpec& spec);

/// The order of convergence again with footprints that are wrong on purpose; each must be noticed.
Json lens_study_mutants(const LensFindings& found);

/// The measured facts about conoid tracing in one sentence; null without views.
Json lens_study_sentence(const LensFindings& found);

}  // namespace sturm
