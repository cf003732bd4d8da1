#pragma once
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "support/source_folder.h"

namespace sturm::testing {

/// Parses tests/reference/<name>.
inline nlohmann::json reference_file(const std::string& name) {
  const std::string path = std::string(STURM_SOURCE_DIR) + "/tests/reference/" + name;
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  return nlohmann::json::parse(in);
}

}  // namespace sturm::testing
