#include "viewer/core/beyond_rim.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sturm::viewer {

namespace {

constexpr float least_margin = 1e-6f;
constexpr int layers = 12;

struct Step {
  int right, down;
};
constexpr std::array<Step, 8> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

class Filling {
 public:
  Filling(std::vector<float>& numbers, int columns, int rows) : numbers_(numbers), columns_(columns), rows_(rows) {
    for (std::size_t k = 0; k < numbers_.size(); k += floats_per_sight)
      known_.push_back(numbers_[k + within_rim] > 0.0f ? 1 : 0);
  }

  /// One layer of nodes beside known ones; false where there are none. `parabolas`: else straight lines.
  bool layer(bool parabolas) {
    std::vector<std::size_t> filled;
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        if (known_[number(i, j)] == 0 && fill(i, j, parabolas)) filled.push_back(number(i, j));
    for (const std::size_t node : filled) known_[node] = 1;
    return !filled.empty();
  }

 private:
  std::size_t number(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  const float* known(int i, int j) const {
    const bool inside = i >= 0 && j >= 0 && i < columns_ && j < rows_;
    return inside && known_[number(i, j)] != 0 ? &numbers_[floats_per_sight * number(i, j)] : nullptr;
  }

  /// The mean over all lines that lead here.
  bool fill(int i, int j, bool parabolas) {
    std::array<float, floats_per_sight> sum{};
    int lines = 0;
    for (const auto [right, down] : steps) {
      const float *a = known(i + right, j + down), *b = known(i + 2 * right, j + 2 * down),
                  *c = known(i + 3 * right, j + 3 * down);
      if (!a || !b || (parabolas && !c)) continue;
      for (std::size_t k = 0; k < floats_per_sight; ++k)
        sum[k] += parabolas ? 3.0f * (a[k] - b[k]) + c[k] : 2.0f * a[k] - b[k];
      ++lines;
    }
    if (lines == 0) return false;
    float* to = &numbers_[floats_per_sight * number(i, j)];
    for (std::size_t k = 0; k < floats_per_sight; ++k) to[k] = sum[k] / static_cast<float>(lines);
    to[within_rim] = std::min(-std::abs(to[within_rim]), -least_margin);
    return true;
  }

  std::vector<float>& numbers_;
  int columns_, rows_;
  std::vector<char> known_;
};

}  // namespace

float margin_of(const Spectacles& lens, const Eigen::Vector3d& exit) {
  const Eigen::Vector3d at = lens.mounting.wearer_from_lens().transpose() * (exit - lens.back_vertex());
  const double radius = 0.5 * lens.diameter_m;
  return std::max(static_cast<float>(1.0 - at.head<2>().squaredNorm() / (radius * radius)), least_margin);
}

void continue_beyond_rim(std::vector<float>& numbers, int columns, int rows) {
  Filling filling(numbers, columns, rows);
  for (int k = 0; k < layers; ++k)
    if (!filling.layer(k == 0)) return;
}

}  // namespace sturm::viewer
