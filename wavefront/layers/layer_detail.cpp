#include "wavefront/layers/layer_detail.h"

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

constexpr std::size_t rim = 2 * 3;  // values of two pixels

/// Four neighbours in a line, one value for each pixel and colour; the middle two exchange light.
struct Line {
  const float *before, *own, *other, *beyond;
};

/// Whether neighbours in a line belong to one surface, 1 or 0: the middle two, and those on either side of them.
struct Joints {
  const float *before, *middle, *beyond;
};

/// Of a difference between neighbours, by the larger one of those beside it: 0 for a step between two plateaus, 1 where
/// it belongs to a slope of several pixels.
float share_of(float difference, float beside) {
  constexpr float none_up_to = 0.2f, all_from = 0.45f;  // of the difference
  const float ratio = beside / std::abs(difference);
  return std::clamp((ratio - none_up_to) / (all_from - none_up_to), 0.0f, 1.0f);
}

/// What the second one of the middle two gives to the first.
void exchange(const Line& line, const Joints& joints, std::size_t count, float* given) {
  constexpr float twelfth = 1.0f / 12.0f, most = 0.25f;
  for (std::size_t i = 0; i < count; ++i) {
    const float own = line.own[i], other = line.other[i];
    const float difference = own - other, limit = most * std::min(own, other);
    const float beside = std::max(joints.before[i] * std::abs(own - line.before[i]),
                                  joints.beyond[i] * std::abs(other - line.beyond[i]));
    const float wanted = std::clamp(twelfth * share_of(difference, beside) * difference, -limit, limit);
    given[i] = joints.middle[i] == 0.0f || difference == 0.0f ? 0.0f : wanted;
  }
}

std::size_t slot(int y, int slots) {
  return static_cast<std::size_t>((y + 6) % slots);
}

}  // namespace

LayerDetail::LayerDetail(const Image& radiance, std::span<const double> vergence_D, std::span<const float> coverage,
                         double jump_D, int left, int right, int top)
    : radiance_(radiance),
      vergence_D_(vergence_D),
      coverage_(coverage),
      jump_D_(jump_D),
      left_(left),
      right_(right),
      y_(top),
      detail_(static_cast<std::size_t>(right - left)) {
  for (Values& row : joined_down_) row.resize(3 * detail_.size());
  for (Values& row : given_down_) row.resize(3 * detail_.size());
  for (Values* row : {&colours_, &joined_right_, &given_right_}) row->resize(3 * detail_.size() + 2 * rim);
  for (int y = y_ - 2; y <= y_; ++y) join_down(y);
  give_down(y_ - 1);
}

std::span<const Detail> LayerDetail::next_row() {
  join_down(y_ + 1);
  give_down(y_);
  give_right(y_);
  const Values &down = given_down_[slot(y_, 2)], &above = given_down_[slot(y_ - 1, 2)];
  const float *const right = given_right_.data() + rim, *const left = right - 3;
  for (std::size_t x = 0, i = 0; x < detail_.size(); ++x)
    for (std::size_t c = 0; c < 3; ++c, ++i) detail_[x][c] = right[i] - left[i] + down[i] - above[i];
  ++y_;
  return detail_;
}

std::size_t LayerDetail::index(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(radiance_.width) + static_cast<std::size_t>(x);
}

const float* LayerDetail::colours(int x, int y) const {
  return radiance_.at(x, std::clamp(y, 0, radiance_.height - 1));
}

bool LayerDetail::same_surface(std::size_t a, std::size_t b) const {
  const bool both = coverage_.empty() || (coverage_[a] > 0.0f && coverage_[b] > 0.0f);
  return both && std::abs(vergence_D_[b] - vergence_D_[a]) <= jump_D_;
}

/// The row y with the next one.
void LayerDetail::join_down(int y) {
  const bool inside = y >= 0 && y + 1 < radiance_.height;
  float* joints = joined_down_[slot(y, 3)].data();
  for (int x = left_; x < right_; ++x, joints += 3)
    std::fill_n(joints, 3, inside && same_surface(index(x, y), index(x, y + 1)) ? 1.0f : 0.0f);
}

void LayerDetail::give_down(int y) {
  const auto joints = [&](int row) { return joined_down_[slot(row, 3)].data(); };
  exchange({colours(left_, y - 1), colours(left_, y), colours(left_, y + 1), colours(left_, y + 2)},
           {joints(y - 1), joints(y), joints(y + 1)}, 3 * detail_.size(), given_down_[slot(y, 2)].data());
}

void LayerDetail::give_right(int y) {
  const int first = std::max(0, left_ - 2), end = std::min(radiance_.width, right_ + 2);
  const auto at = [&](Values& row, int x) { return row.data() + rim + 3 * (x - left_); };
  std::copy_n(colours(first, y), 3 * (end - first), at(colours_, first));
  for (int x = first; x + 1 < end; ++x)
    std::fill_n(at(joined_right_, x), 3, same_surface(index(x, y), index(x + 1, y)) ? 1.0f : 0.0f);
  const float *const here = at(colours_, left_ - 1), *const joints = at(joined_right_, left_ - 1);
  exchange({here - 3, here, here + 3, here + 6}, {joints - 3, joints, joints + 3}, 3 * detail_.size() + 3,
           at(given_right_, left_ - 1));
}

}  // namespace sturm
