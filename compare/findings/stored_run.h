#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// A file that a run read.
struct StoredInput {
  std::string file, sha256;
};

/// How a stored run was made: the object "provenance" that io/json/manifest.h writes.
struct StoredRun {
  std::optional<double> seed, threads;
  std::map<std::string, double> seconds;  ///< by part of the run; "total" among them
  std::string cpu, instruction_set, version, commit, started_utc;
  std::vector<StoredInput> inputs;

  std::optional<double> total_seconds() const;
};

/// Of a report ("sturm.report/1" or "sturm.bench/1"); whatever is missing is left empty.
StoredRun read_stored_run(const Json& report);

}  // namespace sturm
