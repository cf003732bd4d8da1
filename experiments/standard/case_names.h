#pragma once
#include <cmath>
#include <cstdio>
#include <string>

namespace sturm {

/// "P172-OS|1 m|6 mm", "…|inf|…": the name of a case in tables and reports.
inline std::string case_name(const std::string& prescription, double distance_m, double pupil_diameter_m) {
  char distance[32], pupil[32];
  if (std::isinf(distance_m))
    std::snprintf(distance, sizeof distance, "inf");
  else
    std::snprintf(distance, sizeof distance, "%g m", distance_m);
  std::snprintf(pupil, sizeof pupil, "%g mm", 1e3 * pupil_diameter_m);
  return prescription + "|" + distance + "|" + pupil;
}

}  // namespace sturm
