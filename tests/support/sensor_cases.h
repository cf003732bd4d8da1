#pragma once
#include <Eigen/Core>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/source_folder.h"
#include "wavefront/fitting/modal_fit.h"

namespace sturm::testing {

/// The numbers of a table below the source folder: comma-separated, lines that start with a letter or # are skipped.
inline std::vector<std::vector<double>> number_table(const std::string& name) {
  std::ifstream in(std::string(STURM_SOURCE_DIR) + "/" + name);
  if (!in) throw std::runtime_error("cannot read " + name);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#' || std::isalpha(static_cast<unsigned char>(line[0]))) continue;
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
  }
  return rows;
}

/// Rows of x [mm], y [mm] and slopes [rad].
inline std::vector<SlopeSample> slope_samples(const std::vector<std::vector<double>>& rows) {
  std::vector<SlopeSample> samples;
  for (const auto& row : rows)
    samples.push_back({1e-3 * Eigen::Vector2d(row[0], row[1]), Eigen::Vector2d(row[2], row[3])});
  return samples;
}

}  // namespace sturm::testing
