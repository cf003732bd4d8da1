#include "app/gate_lines.h"

#include <nlohmann/json.hpp>

#include "io/files/formatted_text.h"

namespace sturm {

std::string gate_lines(std::span<const GateResult> results) {
  std::string lines;
  for (const GateResult& r : results) {
    const std::string value = r.value ? Json(*r.value).dump() : r.cases == 0u ? "no case" : "no value";
    lines += formatted("%s  %-36s %s %s (bound %s)\n", r.has_passed() ? "pass" : "FAIL", r.id.c_str(), value.c_str(),
                       r.unit.c_str(), Json(r.bound.value_or(0.0)).dump().c_str());
  }
  return lines;
}

}  // namespace sturm
