#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "compare/findings/measurement.h"
#include "io/json/json.h"

namespace sturm {

/// Section "reference": the conoid and the closed form of sin² against independently computed numbers.
struct ReferenceFinding {
  std::string file;                                  ///< with those numbers
  std::optional<std::uint64_t> cases;                ///< in it
  std::map<std::string, Number> max_relative_error;  ///< over all cases, by quantity
};

Json to_json(const ReferenceFinding& finding);

/// Of a report ("sturm.report/1").
ReferenceFinding read_reference(const Json& report);

void measure_reference(const Json& report, Measurements& out);

}  // namespace sturm
