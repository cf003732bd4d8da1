#include "viewer/core/sight_grid.h"

#include <algorithm>
#include <array>
#include <utility>

#include "viewer/core/beyond_rim.h"

namespace sturm::viewer {

namespace {

constexpr std::size_t floats = floats_per_sight;
using Weights = std::array<float, 4>;

/// Cubic weights of four nodes 0, 2, 4, 6 at the places 1, 3 and 5.
constexpr std::array<Weights, 3> between{{{5.0f / 16, 15.0f / 16, -5.0f / 16, 1.0f / 16},
                                          {-1.0f / 16, 9.0f / 16, 9.0f / 16, -1.0f / 16},
                                          {1.0f / 16, -5.0f / 16, 15.0f / 16, 5.0f / 16}}};

float* put(float* to, const Eigen::Vector3d& v, float last) {
  for (const double x : v) *to++ = static_cast<float>(x);
  *to++ = last;
  return to;
}

class Grid {
 public:
  Grid(const PicturePlane& head, const Eye& eye, const Spectacles* lens, const SlopeNodes& nodes)
      : head_(head),
        eye_(eye),
        lens_(lens),
        nodes_(nodes),
        numbers_(floats * static_cast<std::size_t>(nodes.columns) * static_cast<std::size_t>(nodes.rows)) {}

  void fill() {
    for (int j = 0; j < nodes_.rows; j += 2) {
      for (int i = 0; i < nodes_.columns; i += 2) trace(i, j);
      for (int i = 1; i < nodes_.columns; i += 2)
        if (!interpolate(at(0, j), floats, i, nodes_.columns)) trace(i, j);
    }
    const std::size_t row = floats * static_cast<std::size_t>(nodes_.columns);
    for (int j = 1; j < nodes_.rows; j += 2)
      for (int i = 0; i < nodes_.columns; ++i)
        if (!interpolate(at(i, 0), row, j, nodes_.rows)) trace(i, j);
  }

  std::vector<float> take() {
    if (stopped_) continue_beyond_rim(numbers_, nodes_.columns, nodes_.rows);
    return std::move(numbers_);
  }

 private:
  float* at(int i, int j) {
    return &numbers_[floats * (static_cast<std::size_t>(j) * static_cast<std::size_t>(nodes_.columns) +
                               static_cast<std::size_t>(i))];
  }

  void trace(int i, int j) {
    const Sight sight =
        traced_sight(head_, eye_, lens_, nodes_.first + Eigen::Vector2d(i, j).cwiseProduct(nodes_.step));
    if (!sight.reaches) {
      stopped_ = true;
      at(i, j)[within_rim] = -1.0f;
      return;
    }
    float* to = put(at(i, j), sight.origin, lens_ ? margin_of(*lens_, sight.origin) : 1.0f);
    to = put(to, sight.direction, 0.0f);
    for (const Sight::Map* map : {&sight.offset_p, &sight.offset_s, &sight.slope_p, &sight.slope_s})
      for (int column = 0; column < 2; ++column) to = put(to, map->col(column), 0.0f);
  }

  /// The node `k`, odd, of a line of `count` nodes, `stride` floats apart, of which the even ones are there. False
  /// where there are no four that reach.
  static bool interpolate(float* line, std::size_t stride, int k, int count) {
    const int last = (count - 1) / 2 * 2, first = std::min(std::max(k - 3, 0), last - 6);
    if (first < 0 || k > last) return false;
    std::array<const float*, 4> from{};
    for (int n = 0; n < 4; ++n)
      from[static_cast<std::size_t>(n)] = line + stride * static_cast<std::size_t>(first + 2 * n);
    for (const float* node : from)
      if (node[within_rim] < 0.0f) return false;
    const Weights& w = between[static_cast<std::size_t>(k - first) / 2];
    float* to = line + stride * static_cast<std::size_t>(k);
    for (std::size_t c = 0; c < floats; ++c)
      to[c] = w[0] * from[0][c] + w[1] * from[1][c] + w[2] * from[2][c] + w[3] * from[3][c];
    return true;
  }

  const PicturePlane& head_;
  const Eye& eye_;
  const Spectacles* lens_;
  SlopeNodes nodes_;
  std::vector<float> numbers_;
  bool stopped_ = false;  // by the spectacles, somewhere
};

}  // namespace

std::vector<float> sight_grid(const PicturePlane& head, const Eye& eye, const Spectacles* lens,
                              const SlopeNodes& nodes) {
  Grid grid(head, eye, lens, nodes);
  grid.fill();
  return grid.take();
}

}  // namespace sturm::viewer
