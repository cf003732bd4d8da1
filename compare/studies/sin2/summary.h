#pragma once
#include <vector>

#include "compare/studies/sin2/sin2_findings.h"
#include "compare/studies/sin2/study_case.h"

namespace sturm {

/// A defocus that a wearer just notices [D]: the step in which lenses come.
inline constexpr double noticeable_defocus_D = 0.25;

/// The section "sin2_study" of a report (configs/schemas/report.schema.json) from all cases; `gallery` is put in as it
/// is.
Sin2StudyFindings summarised_sin2_study(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases,
                                        std::vector<Sin2GalleryEntry> gallery);

/// Its parts: what each model did, the checks that gates read, the distribution over the real eyes, and what the
/// figures show.
std::vector<Sin2ModelRow> model_table(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases);
Sin2Checks study_checks(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases);
std::vector<Sin2PopulationRow> population_table(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases);
Sin2ReferenceView reference_views(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases);

}  // namespace sturm
