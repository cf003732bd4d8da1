#pragma once
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// A lens and its sturm.lens_report/1.
struct NamedLensReport {
  std::string name;
  Json report;
};

/// Lenses for people: a line for each with its powers, thickness, and the largest errors over its gazes.
std::string lens_table(const std::vector<NamedLensReport>& lenses);

/// Lenses for programs: a line for each gaze through each of them, with the names and units of the report.
std::string lens_csv(const std::vector<NamedLensReport>& lenses);

}  // namespace sturm
