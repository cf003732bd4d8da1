#include "io/images/tiff_header.h"

#include <algorithm>
#include <string>

#include "io/images/big_endian.h"

namespace sturm {

bool tiff_is_multiplied_by_alpha(const BytesAt& bytes_at) {
  constexpr std::uint64_t big_version = 43, extra_samples = 338, times_alpha = 1, most_entries = 4096;
  const bool little = bytes_at(0, 1) == "I";
  const auto number = [&](std::uint64_t at, std::size_t count) {
    std::string bytes = bytes_at(at, count);
    bytes.resize(count);  // zeros behind the end of the file
    if (little) std::reverse(bytes.begin(), bytes.end());
    return big_endian(bytes, 0, count);
  };
  const bool big = number(2, 2) == big_version;
  const std::size_t size = big ? 20 : 12, value = big ? 12 : 8;
  const std::uint64_t directory = big ? number(8, 8) : number(4, 4);
  const std::uint64_t first = directory + (big ? 8 : 2), entries = number(directory, big ? 8 : 2);
  for (std::uint64_t i = 0; i < std::min(entries, most_entries); ++i)
    if (number(first + i * size, 2) == extra_samples) return number(first + i * size + value, 2) == times_alpha;
  return false;
}

}  // namespace sturm
