#include "conoid/pictures/pupil_passes.h"

#include <cmath>
#include <numbers>

namespace sturm {

std::vector<PupilPass> pupil_passes(int count, double turn) {
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  constexpr double plastic = 1.32471795724474602596;  // x³ = x + 1
  constexpr double step_x = 1.0 / plastic, step_y = 1.0 / (plastic * plastic);
  const auto fraction = [](double x) { return static_cast<float>(x - std::floor(x)); };
  std::vector<PupilPass> passes;
  for (int k = 0; k < count; ++k) {
    const double r = std::sqrt((k + 0.5) / count), angle = golden_angle * k + 2.0 * std::numbers::pi * turn;
    PupilPass pass;
    pass.pupil = {static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle))};
    // The recurrence runs on through the turns: 4096 · turn is another stretch of it for each of 16 turns.
    const double n = k + 0.5 + 4096.0 * turn;
    pass.film = {std::min(fraction(n * step_x), 0.99999994f), std::min(fraction(n * step_y), 0.99999994f)};
    passes.push_back(pass);
  }
  return passes;
}

std::vector<std::vector<PupilPass>> interleaved_passes(int count) {
  // Bayer's matrix: pixels that touch take turns that are far apart.
  constexpr int order[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  std::vector<std::vector<PupilPass>> sets;
  for (const int turn : order) sets.push_back(pupil_passes(count, turn / 16.0));
  return sets;
}

}  // namespace sturm
