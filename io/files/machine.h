#pragma once
#include <array>
#include <cstdint>
#include <optional>

namespace sturm {

/// What the numbers of a run depend on besides the program.
struct Machine {
  int logical_processors = 1;
  std::optional<int> cores;                   ///< physical ones; none where the operating system does not say
  std::optional<std::uint64_t> memory_bytes;  ///< physical memory
  std::optional<std::array<double, 3>> load;  ///< runnable tasks on average over 1, 5 and 15 minutes
};

/// As it is now. The processor's name is `cpu_model()`.
Machine this_machine();

/// The largest memory that this process has had in use so far (resident set) [bytes].
std::uint64_t peak_memory_bytes();

}  // namespace sturm
