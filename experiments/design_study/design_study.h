#pragma once
#include <string>
#include <vector>

#include "compare/studies/designs/design_findings.h"
#include "io/json/json.h"
#include "io/specs/experiment/design_study_spec.h"
#include "reports/plots/figure.h"

namespace sturm {

/// What was asked, for the report.
DesignConditions conditions_of(const DesignStudySpec& study);

/// A design as worn, made for its own prescription.
DesignFacts facts_of(const DesignStudySpec& study, const StudyDesign& design);

/// What the population sees through a design: a row for each wearer and distance. Throws InputError for a design that
/// can be made for nobody.
std::vector<DesignWearer> wearers_of(const DesignStudySpec& study, const StudyDesign& design);

/// The wearers as a table.
std::string design_study_csv(const DesignFindings& found);

/// Maps, differences, corridors of progressive designs, fields of ellipses, and how many wearers have how much blur.
std::vector<Figure> design_figures(const DesignStudySpec& study, const DesignFindings& found);

/// What was measured, in one sentence; null without wearers.
Json design_sentence(const DesignFindings& found);

}  // namespace sturm
