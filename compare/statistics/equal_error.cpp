#include "compare/statistics/equal_error.h"

#include <algorithm>
#include <cmath>

namespace sturm {

std::optional<double> NoiseOverTime::order() const {
  if (!(more_.variance > 0.0 && fewer_.variance > more_.variance)) return std::nullopt;
  return std::log(fewer_.variance / more_.variance) / std::log(more_.samples / fewer_.samples);
}

std::optional<double> NoiseOverTime::samples_for(double variance) const {
  const auto p = order();
  if (!p || !(variance > 0.0)) return std::nullopt;
  return more_.samples * std::pow(more_.variance / variance, 1.0 / *p);
}

std::optional<double> NoiseOverTime::variance_of(double samples) const {
  const auto p = order();
  if (!p || !(samples > 0.0)) return std::nullopt;
  return more_.variance * std::pow(more_.samples / samples, *p);
}

double NoiseOverTime::seconds_for(double samples) const {
  const double fixed = more_.seconds - more_.samples * seconds_per_sample();
  return std::max(0.0, fixed) + samples * (more_.seconds - std::max(0.0, fixed)) / more_.samples;
}

}  // namespace sturm
