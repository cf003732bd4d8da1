#pragma once
#include <filesystem>

namespace sturm {

struct RunOptions {
  std::filesystem::path folder;  ///< where the report goes
  int threads = 0;               ///< for the provenance
  bool resume = false;
  bool quiet = false;
};

}  // namespace sturm
