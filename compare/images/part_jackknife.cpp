#include "compare/images/part_jackknife.h"

#include <algorithm>
#include <cmath>

#include "compare/statistics/jackknife.h"

namespace sturm {

std::vector<double> shares_of_mean(const Image& map, int least_side_px) {
  const int across = std::max(1, map.width / least_side_px), down = std::max(1, map.height / least_side_px);
  std::vector<double> shares(static_cast<std::size_t>(across) * down, 0.0);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      shares[static_cast<std::size_t>(y * down / map.height) * across +
             static_cast<std::size_t>(x * across / map.width)] += *map.at(x, y);
  for (double& share : shares) share /= static_cast<double>(map.width) * map.height;
  return shares;
}

PartError jackknife_by_parts(std::span<const std::vector<double>> left_out) {
  const double degrees_of_part = static_cast<double>(left_out.size()) - 1.0;
  double variance = 0.0, squares = 0.0;
  std::vector<double> of_part(left_out.size());
  for (std::size_t part = 0; part < left_out.front().size(); ++part) {
    std::transform(left_out.begin(), left_out.end(), of_part.begin(),
                   [part](const std::vector<double>& shares) { return shares[part]; });
    const double error = jackknife_standard_error(of_part);
    variance += error * error;
    squares += error * error * error * error;
  }
  if (!(variance > 0.0)) return {};
  return {std::sqrt(variance), degrees_of_part * variance * variance / squares};
}

}  // namespace sturm
