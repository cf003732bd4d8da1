#include "compare/findings/stored_run.h"

#include "io/json/record.h"

namespace sturm {

template <>
inline constexpr auto record_members<StoredInput> = std::tuple{
    member("file", &StoredInput::file),
    member("sha256", &StoredInput::sha256),
};

template <>
inline constexpr auto record_members<StoredRun> = std::tuple{
    member("seed", &StoredRun::seed),
    member("threads", &StoredRun::threads),
    member("seconds", &StoredRun::seconds),
    member("cpu", &StoredRun::cpu),
    member("instruction_set", &StoredRun::instruction_set),
    member("version", &StoredRun::version),
    member("commit", &StoredRun::commit),
    member("started_utc", &StoredRun::started_utc),
    member("inputs", &StoredRun::inputs),
};

std::optional<double> StoredRun::total_seconds() const {
  const auto total = seconds.find("total");
  return total == seconds.end() ? std::nullopt : std::optional(total->second);
}

StoredRun read_stored_run(const Json& report) {
  return record_from<StoredRun>(value_at(report, "provenance"));
}

}  // namespace sturm
