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

/// Several lenses for people: a line for each with its powers, thickness, and the largest errors over its gazes.
std::string lens_table(const std::vector<NamedLensReport>& lenses);

}  // namespace sturm
