#include "conoid/pictures/ellipse_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lensmodel/symmetric2.h"

namespace sturm {
namespace {

using std::numbers::pi;

/// A grid line in the space of the unit disc: all u with n·u = t, where n is the unit normal of that family of lines.
/// The part of the disc beyond the line is a cap that spans ±angle about n.
struct GridLine {
  double t, angle, sine, cap;

  explicit GridLine(double t_)
      : t(std::clamp(t_, -1.0, 1.0)),
        angle(std::acos(t)),
        sine(std::sqrt((1.0 - t) * (1.0 + t))),
        cap(angle - t * sine) {}
};

/// The two families of grid lines as the unit disc sees them. All that matters of the ellipse's shape is the angle
/// between their normals.
class DiscGrid {
 public:
  DiscGrid(const Eigen::Matrix2d& map)
      : half_width(std::hypot(map(0, 0), map(0, 1))),
        half_height(std::hypot(map(1, 0), map(1, 1))),
        determinant(std::abs(difference_of_products(map(0, 0), map(1, 1), map(0, 1), map(1, 0)))),
        angle_(std::atan2(determinant, map(0, 0) * map(1, 0) + map(0, 1) * map(1, 1))),
        sine_(std::sin(angle_)),
        cosine_(std::cos(angle_)) {}

  /// Area of the disc beyond both lines: the intersection of two caps.
  double beyond(const GridLine& x, const GridLine& y) const {
    if (x.angle + y.angle <= angle_) return 0.0;                               // disjoint
    if (std::abs(x.angle - y.angle) >= angle_) return std::min(x.cap, y.cap);  // one in the other
    if (x.angle + y.angle + angle_ >= 2.0 * pi) return x.cap + y.cap - pi;     // together they cover the disc
    // The chords cross at P. Green's theorem along chord y, the common arc, chord x; s are P's positions along the
    // chords.
    const double s_x = std::clamp((y.t - x.t * cosine_) / sine_, -x.sine, x.sine);
    const double s_y = std::clamp((y.t * cosine_ - x.t) / sine_, -y.sine, y.sine);
    return 0.5 * (x.angle + y.angle - angle_ - x.t * (x.sine - s_x) - y.t * (y.sine + s_y));
  }

  /// Ends of the ellipse's section along a horizontal line, in half widths.
  double left(const GridLine& y) const { return y.t * cosine_ - y.sine * sine_; }
  double right(const GridLine& y) const { return y.t * cosine_ + y.sine * sine_; }

  /// Ends of the part of the ellipse between two horizontal lines, in half widths.
  double leftmost(const GridLine& y0, const GridLine& y1) const {
    return y0.t <= -cosine_ && -cosine_ <= y1.t ? -1.0 : std::min(left(y0), left(y1));
  }
  double rightmost(const GridLine& y0, const GridLine& y1) const {
    return y0.t <= cosine_ && cosine_ <= y1.t ? 1.0 : std::max(right(y0), right(y1));
  }

  const double half_width, half_height, determinant;

 private:
  double angle_, sine_, cosine_;  // between the normals of the two families, [0, π]
};

int floor_int(double x) {
  return static_cast<int>(std::floor(x));
}

}  // namespace

EllipseKernel::EllipseKernel(const Eigen::Matrix2d& map, const Eigen::Vector2d& source) {
  const DiscGrid grid(map);
  const auto column_line = [&](int x) {
    return GridLine((x - source.x()) / grid.half_width);
  };  // ±∞ for a vertical focal line
  const auto row_line = [&](int y) { return GridLine((y - source.y()) / grid.half_height); };

  first_row_ = floor_int(source.y() - grid.half_height);
  const int end_row = floor_int(source.y() + grid.half_height) + 1;
  const int first_column = floor_int(source.x() - grid.half_width);
  const int end_column = floor_int(source.x() + grid.half_width) + 1;
  std::vector<GridLine> columns;
  for (int x = first_column; x <= end_column; ++x) columns.push_back(column_line(x));
  inner_weight_ = grid.determinant > 0.0 ? 1.0 / (pi * grid.determinant) : 0.0;

  GridLine upper = row_line(first_row_);
  for (int y = first_row_; y < end_row; ++y) {
    const GridLine lower = row_line(y + 1);
    Row row;
    row.begin = std::max(first_column, floor_int(source.x() + grid.half_width * grid.leftmost(upper, lower)));
    row.end = std::min(end_column, floor_int(source.x() + grid.half_width * grid.rightmost(upper, lower)) + 1);
    row.inner_begin = row.inner_end = row.end;
    if (upper.t > -1.0 && lower.t < 1.0) {  // a box is inside the ellipse where its four corners are
      const int from =
          static_cast<int>(std::ceil(source.x() + grid.half_width * std::max(grid.left(upper), grid.left(lower))));
      const int to = floor_int(source.x() + grid.half_width * std::min(grid.right(upper), grid.right(lower)));
      if (from < to) row.inner_begin = std::max(row.begin, from), row.inner_end = std::min(row.end, to);
    }
    row.edges = edge_weights_.size();
    const auto strip_beyond = [&](int x) {  // area of the row's strip to the right of grid line x
      const GridLine& line = columns[static_cast<std::size_t>(x - first_column)];
      return grid.beyond(line, upper) - grid.beyond(line, lower);
    };
    const auto add_edge = [&](int from, int to) {
      if (from >= to) return;
      double area = strip_beyond(from);
      for (int x = from; x < to; ++x) {
        const double next = strip_beyond(x + 1);
        edge_weights_.push_back(std::max(0.0, (area - next) / pi));
        area = next;
      }
    };
    add_edge(row.begin, row.inner_begin);
    add_edge(row.inner_end, row.end);
    rows_.push_back(row);
    upper = lower;
  }
}

}  // namespace sturm
