#pragma once
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "support/reference_file.h"
#include "wavefront/psf/pupil_wave.h"

namespace sturm::testing {

inline constexpr double arcmin = 3.14159265358979323846 / 180.0 / 60.0;

/// W in the examiner's frame, as the references have it, from OSA coefficients [µm].
inline PupilWave examiner_wave(const std::vector<double>& osa_um, double measured_mm, double pupil_mm,
                               double stiles_crawford_per_mm2 = 0.0, double in_focus_nm = 555.0) {
  std::vector<double> metres;
  for (const double c : osa_um) metres.push_back(1e-6 * c);
  const ZernikeWave wearer = ZernikeWave::from_examiner(metres, 0.5e-3 * measured_mm);
  return PupilWave{wearer, 0.5e-3 * pupil_mm, 1e6 * stiles_crawford_per_mm2, in_focus_nm}.mirrored();
}

/// Coefficients {"3": …} as a list.
inline std::vector<double> coefficient_list(const nlohmann::json& by_index) {
  std::vector<double> c(1, 0.0);
  for (const auto& [key, value] : by_index.items()) {
    const std::size_t j = std::stoul(key);
    if (c.size() <= j) c.resize(j + 1, 0.0);
    c[j] = value.get<double>();
  }
  return c;
}

/// One of H. Hofer's eyes, by its number in configs/data/hofer_9_subjects_6mm.csv [µm over 6 mm].
inline std::vector<double> hofer_eye(int subject) {
  std::ifstream in(std::string(STURM_SOURCE_DIR) + "/configs/data/hofer_9_subjects_6mm.csv");
  std::string line;
  while (std::getline(in, line)) {
    if (!line.starts_with(std::to_string(subject) + ",")) continue;
    std::istringstream fields(line);
    std::vector<double> c;
    std::string field;
    std::getline(fields, field, ',');
    while (std::getline(fields, field, ',')) c.push_back(std::stod(field));
    return c;
  }
  throw std::runtime_error("no such eye");
}

}  // namespace sturm::testing
