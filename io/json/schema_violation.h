#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// Where a document breaks its schema.
struct Violation {
  std::vector<std::string> path;  ///< object keys and array indices from the root
  std::string missing;            ///< the required member that is not there; "" for every other violation
};

/// First violation of a self-contained draft 7 schema. (valijson, alone in its translation unit: it is slow to
/// compile.)
std::optional<Violation> first_violation(const Json& document, const Json& schema);

}  // namespace sturm
