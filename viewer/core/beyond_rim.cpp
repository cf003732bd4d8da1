#include "viewer/core/beyond_rim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sturm::viewer {

namespace {

constexpr float least_margin = 1e-6f;

struct Step {
  int right, down;
};
constexpr std::array<Step, 8> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

enum class State : char { stopped, waiting, known };

class Filling {
 public:
  Filling(std::vector<float>& numbers, int columns, int rows)
      : numbers_(numbers), columns_(columns), rows_(rows), states_(numbers.size() / floats_per_sight, State::stopped) {
    for (std::size_t node = 0; node < states_.size(); ++node)
      if (numbers_[floats_per_sight * node + within_rim] > 0.0f) states_[node] = State::known;
    for (std::size_t node = 0; node < states_.size(); ++node)
      if (states_[node] == State::known) wake_beside(node);
  }

  /// One layer of nodes beside known ones; false where there is none. `parabolas`: else straight lines.
  bool layer(bool parabolas) {
    std::vector<std::size_t> filled, left;
    for (const std::size_t node : waiting_) (fill(node, parabolas) ? filled : left).push_back(node);
    waiting_ = std::move(left);
    for (const std::size_t node : filled) states_[node] = State::known;
    for (const std::size_t node : filled) wake_beside(node);
    return !filled.empty();
  }

 private:
  int column_of(std::size_t node) const { return static_cast<int>(node) % columns_; }
  int row_of(std::size_t node) const { return static_cast<int>(node) / columns_; }
  bool has(int i, int j) const { return i >= 0 && j >= 0 && i < columns_ && j < rows_; }
  std::size_t number(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  const float* known(int i, int j) const {
    return has(i, j) && states_[number(i, j)] == State::known ? &numbers_[floats_per_sight * number(i, j)] : nullptr;
  }

  void wake_beside(std::size_t node) {
    for (const auto [right, down] : steps) {
      const int i = column_of(node) + right, j = row_of(node) + down;
      if (!has(i, j) || states_[number(i, j)] != State::stopped) continue;
      states_[number(i, j)] = State::waiting;
      waiting_.push_back(number(i, j));
    }
  }

  /// The mean over all lines that lead here.
  bool fill(std::size_t node, bool parabolas) {
    const int i = column_of(node), j = row_of(node);
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
    float* to = &numbers_[floats_per_sight * node];
    for (std::size_t k = 0; k < floats_per_sight; ++k) to[k] = sum[k] / static_cast<float>(lines);
    to[within_rim] = std::min(-std::abs(to[within_rim]), -least_margin);
    return true;
  }

  std::vector<float>& numbers_;
  int columns_, rows_;
  std::vector<State> states_;
  std::vector<std::size_t> waiting_;
};

}  // namespace

float margin_of(const Spectacles& lens, const Eigen::Vector3d& exit) {
  const Eigen::Vector3d at = lens.mounting.wearer_from_lens().transpose() * (exit - lens.back_vertex());
  const double radius = 0.5 * lens.diameter_m;
  return std::max(static_cast<float>(1.0 - at.head<2>().squaredNorm() / (radius * radius)), least_margin);
}

void continue_beyond_rim(std::vector<float>& numbers, int columns, int rows) {
  Filling filling(numbers, columns, rows);
  filling.layer(true);
  while (filling.layer(false)) {
  }
}

}  // namespace sturm::viewer
