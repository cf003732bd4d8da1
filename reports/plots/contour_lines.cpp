#include "reports/plots/contour_lines.h"

#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <utility>

namespace sturm {

namespace {

/// Both cells beside a side compute its crossing from the same two corners, though not in the same order: ends that
/// meet agree to rounding, and no two lines of one level come as near as this.
std::pair<long long, long long> place_of(const Eigen::Vector2d& p) {
  constexpr double cells = 1e7;
  return {std::llround(cells * p.x()), std::llround(cells * p.y())};
}

using Ends = std::multimap<std::pair<long long, long long>, std::size_t>;

/// A piece that has not been used and has an end at `place`; it is used then.
std::optional<std::size_t> take(const Ends& ends, const Eigen::Vector2d& place, std::vector<bool>& used) {
  const auto [first, last] = ends.equal_range(place_of(place));
  for (auto at = first; at != last; ++at)
    if (!used[at->second]) {
      used[at->second] = true;
      return at->second;
    }
  return std::nullopt;
}

const Eigen::Vector2d& other_end(const ContourPiece& piece, const Eigen::Vector2d& end) {
  return place_of(piece[0]) == place_of(end) ? piece[1] : piece[0];
}

}  // namespace

std::vector<ContourPiece> contour_lines(const Eigen::MatrixXd& values, double level) {
  std::vector<ContourPiece> pieces;
  for (Eigen::Index row = 0; row + 1 < values.rows(); ++row)
    for (Eigen::Index column = 0; column + 1 < values.cols(); ++column) {
      // Counter-clockwise from (column, row), with side k from corner k to corner k + 1.
      const Eigen::Vector2d origin{double(column), double(row)};
      const std::array<Eigen::Vector2d, 4> corner{origin, origin + Eigen::Vector2d(1, 0),
                                                  origin + Eigen::Vector2d(1, 1), origin + Eigen::Vector2d(0, 1)};
      const std::array<double, 4> above{values(row, column) - level, values(row, column + 1) - level,
                                        values(row + 1, column + 1) - level, values(row + 1, column) - level};
      const double mean = 0.25 * (above[0] + above[1] + above[2] + above[3]);
      if (!std::isfinite(mean)) continue;
      std::vector<Eigen::Vector2d> crossings;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        if ((above[k] >= 0.0) == (above[next] >= 0.0)) continue;
        const double t = above[k] / (above[k] - above[next]);
        crossings.push_back(corner[k] + t * (corner[next] - corner[k]));
      }
      if (crossings.size() == 2) {
        pieces.push_back({crossings[0], crossings[1]});
      } else if (crossings.size() == 4) {  // cut off the corners that are on the other side than the middle
        const std::size_t first = (above[0] >= 0.0) == (mean >= 0.0) ? 0 : 3;
        pieces.push_back({crossings[first], crossings[(first + 1) % 4]});
        pieces.push_back({crossings[(first + 2) % 4], crossings[(first + 3) % 4]});
      }
    }
  return pieces;
}

std::vector<ContourLine> joined(const std::vector<ContourPiece>& pieces) {
  Ends ends;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const Eigen::Vector2d& end : pieces[i]) ends.emplace(place_of(end), i);
  std::vector<bool> used(pieces.size());
  std::vector<ContourLine> lines;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    std::deque<Eigen::Vector2d> line{pieces[i][0], pieces[i][1]};
    while (const auto next = take(ends, line.back(), used)) line.push_back(other_end(pieces[*next], line.back()));
    while (const auto next = take(ends, line.front(), used)) line.push_front(other_end(pieces[*next], line.front()));
    lines.emplace_back(line.begin(), line.end());
  }
  return lines;
}

}  // namespace sturm
