#include "io/images/depth_edges.h"

#include <cmath>

namespace sturm {

std::vector<std::size_t> depth_edges(const std::vector<double>& vergence_D, int width, int height, double jump_D) {
  std::vector<char> edge(vergence_D.size(), 0);
  const auto compare = [&](int x_from, int x_to, int y_end, int dx, int dy) {
    for (int y = 0; y < y_end; ++y) {
      const std::size_t row = static_cast<std::size_t>(y) * width;
      const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(dy) * width + dx;
      for (int x = x_from; x < x_to; ++x) {
        const std::size_t i = row + x, j = i + step;
        const char differs = std::abs(vergence_D[i] - vergence_D[j]) > jump_D;
        edge[i] |= differs;
        edge[j] |= differs;
      }
    }
  };
  compare(0, width - 1, height, 1, 0);
  compare(0, width, height - 1, 0, 1);
  compare(0, width - 1, height - 1, 1, 1);
  compare(1, width, height - 1, -1, 1);
  std::vector<std::size_t> edges;
  for (std::size_t i = 0; i < edge.size(); ++i)
    if (edge[i]) edges.push_back(i);
  return edges;
}

}  // namespace sturm
