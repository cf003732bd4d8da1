#pragma once
#include <string>

#include "experiments/stress/suite.h"
#include "io/json/json.h"

namespace sturm::stress {

/// The summary as a table for people.
std::string table_of(const SuiteSummary& summary);

/// A sturm.stress_report/1 document. Nothing in it depends on threads or time.
Json report_of(const SuiteSummary& summary);

/// One case in full: its sturm.ellipse/1 document (and the table that it names), results in double and in extended
/// precision, and every check.
Json case_json(std::uint64_t seed, std::uint64_t index, const CaseRun& run, const FreeFormLenses& free_forms);

}  // namespace sturm::stress
