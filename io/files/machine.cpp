#include "io/files/machine.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <thread>

namespace sturm {

namespace {

/// Different pairs of package and core in /proc/cpuinfo.
std::optional<int> physical_cores() {
  std::ifstream stream("/proc/cpuinfo");
  std::set<std::string> cores;
  std::string package;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("physical id")) package = line;
    if (line.starts_with("core id")) cores.insert(package + line);
  }
  return cores.empty() ? std::nullopt : std::optional(static_cast<int>(cores.size()));
}

}  // namespace

Machine this_machine() {
  Machine machine;
  if (const unsigned n = std::thread::hardware_concurrency(); n > 0) machine.logical_processors = static_cast<int>(n);
  machine.cores = physical_cores();
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  if (pages > 0 && page > 0)
    machine.memory_bytes = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
  std::array<double, 3> load{};
  if (getloadavg(load.data(), 3) == 3) machine.load = load;
  return machine;
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

}  // namespace sturm
