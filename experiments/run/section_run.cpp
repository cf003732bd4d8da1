#include "experiments/run/section_run.h"

#include <nlohmann/json.hpp>

namespace sturm {

void append(Json& list, const Json& entries) {
  list.insert(list.end(), entries.begin(), entries.end());
}

}  // namespace sturm
