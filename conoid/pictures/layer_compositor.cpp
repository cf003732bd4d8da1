#include "conoid/pictures/layer_compositor.h"

#include <algorithm>

#include "conoid/threads/parallel_for.h"

namespace sturm {

namespace {
constexpr int rows_per_band = 8;
}

void LayerCompositor::Light::add(const Light& other) {
  for (int c = 0; c < 3; ++c) rgb[c] += other.rgb[c];
  coverage += other.coverage;
}

LayerCompositor::Light LayerCompositor::weighted(const Spot& spot, double weight) {
  weight *= static_cast<double>(spot.coverage);
  return {{weight * spot.rgb[0], weight * spot.rgb[1], weight * spot.rgb[2]}, weight};
}

LayerCompositor::LayerCompositor(int width, int height, int spots_per_pixel)
    : width_(width),
      height_(height),
      per_spot_(1.0 / spots_per_pixel),
      layer_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      total_(layer_.size()) {}

void LayerCompositor::add_layer(std::span<const Spot> spots, std::span<const EllipseKernel> kernels) {
  if (spots.empty()) return;
  int reach_up = 0, reach_down = 0;
  for (const EllipseKernel& k : kernels) {
    reach_up = std::max(reach_up, -k.first_row());
    reach_down = std::max(reach_down, k.first_row() + static_cast<int>(k.rows().size()) - 1);
  }
  const int first_row = std::max(0, spots.front().y - reach_up),
            end_row = std::min(height_, spots.back().y + reach_down + 1);
  if (first_row >= end_row) return;
  parallel_for(first_row / rows_per_band, (end_row - 1) / rows_per_band + 1, [&](int band) {
    const int row0 = band * rows_per_band, row1 = std::min(height_, row0 + rows_per_band);
    std::fill(layer_.begin() + static_cast<std::ptrdiff_t>(row0) * width_,
              layer_.begin() + static_cast<std::ptrdiff_t>(row1) * width_, Light{});
    auto s = std::lower_bound(spots.begin(), spots.end(), row0 - reach_down,
                              [](const Spot& a, int row) { return a.y < row; });
    for (; s != spots.end() && s->y < row1 + reach_up; ++s) spread(*s, kernels, row0, row1);
    composite(row0, row1);
  });
}

void LayerCompositor::spread(const Spot& s, std::span<const EllipseKernel> kernels, int row0, int row1) {
  if (s.kernel == Spot::copied) {
    if (s.x >= 0 && s.x < width_ && s.y >= row0 && s.y < row1)
      layer_[static_cast<std::size_t>(s.y) * width_ + s.x].add(weighted(s, 1.0));
    return;
  }
  const EllipseKernel& kernel = kernels[static_cast<std::size_t>(s.kernel)];
  const Light inner = weighted(s, kernel.inner_weight());
  const int top = s.y + kernel.first_row();
  const int y_end = std::min(row1, top + static_cast<int>(kernel.rows().size()));
  for (int y = std::max(row0, top); y < y_end; ++y) {
    const EllipseKernel::Row& row = kernel.rows()[y - top];
    Light* const out = &layer_[static_cast<std::size_t>(y) * width_];
    const auto clipped = [&](int column) { return std::clamp(s.x + column, 0, width_); };
    const auto add_edges = [&](int from, int to, const double* weights) {
      for (int x = clipped(from), x_end = clipped(to); x < x_end; ++x) out[x].add(weighted(s, weights[x - s.x - from]));
    };
    const double* const weights = kernel.edge_weights().data() + row.edges;
    add_edges(row.begin, row.inner_begin, weights);
    for (int x = clipped(row.inner_begin), x_end = clipped(row.inner_end); x < x_end; ++x) out[x].add(inner);
    add_edges(row.inner_end, row.end, weights + (row.inner_begin - row.begin));
  }
}

void LayerCompositor::composite(int row0, int row1) {
  for (std::size_t i = static_cast<std::size_t>(row0) * width_; i < static_cast<std::size_t>(row1) * width_; ++i) {
    const double alpha = layer_[i].coverage * per_spot_;
    const double added = std::min(alpha, 1.0 - total_[i].coverage);
    if (!(added > 0.0)) continue;
    const double scale = per_spot_ * (added / alpha);
    for (int c = 0; c < 3; ++c) total_[i].rgb[c] += scale * layer_[i].rgb[c];
    total_[i].coverage += added;
  }
}

Image LayerCompositor::radiance() const {
  Image image(width_, height_, 3);
  for (std::size_t i = 0; i < total_.size(); ++i)
    if (total_[i].coverage > 0.0)
      for (int c = 0; c < 3; ++c) image.pixels[3 * i + c] = static_cast<float>(total_[i].rgb[c] / total_[i].coverage);
  return image;
}

Image LayerCompositor::coverage() const {
  Image image(width_, height_, 1);
  for (std::size_t i = 0; i < total_.size(); ++i) image.pixels[i] = static_cast<float>(total_[i].coverage);
  return image;
}

}  // namespace sturm
