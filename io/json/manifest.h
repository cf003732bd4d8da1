#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// What a run knows about itself; the build adds its own facts.
struct RunFacts {
  int threads = 0;
  std::uint64_t seed = 0;
  std::string started_utc;                ///< ISO 8601, see utc_now()
  std::map<std::string, double> seconds;  ///< wall-clock by part; "total" among them
  std::vector<std::string> input_files;   ///< hashed when the manifest is made
};

/// The object "provenance" of a report: version, commit, compiler, flags, instruction set, CPU, threads, seed, hash of
/// the resolved spec, start, seconds, peak memory of the process so far, inputs with their SHA-256. Throws InputError
/// if an input file has gone.
Json provenance(const RunFacts& run, const Json& resolved_spec);

/// A document of format sturm.manifest/1: provenance, resolved spec, counters and notes; what lies beside an image.
Json manifest(const RunFacts& run, const Json& resolved_spec, const Json& counters,
              const std::vector<std::string>& notes);

/// Hash that names a run: SHA-256 of the resolved spec's canonical text (sorted keys, no blanks).
std::string spec_hash(const Json& resolved_spec);

/// Model name of the processor as the operating system gives it; "unknown" where it does not.
std::string cpu_model();

/// Instruction-set extensions that this library was compiled for, e.g. "x86-64" or "x86-64 avx2 fma avx512f".
std::string instruction_set();

/// The time now, "2024-05-31T12:00:00Z".
std::string utc_now();

}  // namespace sturm
