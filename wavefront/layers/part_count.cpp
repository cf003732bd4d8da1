#include "wavefront/layers/part_count.h"

namespace sturm {

std::span<const ErrorOfParts> errors_of_parts() {
  static constexpr ErrorOfParts table[] = {{1, 0.007}, {4, 0.004}, {8, 0.0024}, {16, 0.002}};
  return table;
}

std::optional<int> parts_for_error(double error) {
  for (const ErrorOfParts& row : errors_of_parts())
    if (row.error <= error) return row.parts;
  return std::nullopt;
}

}  // namespace sturm
