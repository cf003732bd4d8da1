#include "wavefront/layers/layer_split.h"

#include <algorithm>

#include "wavefront/layers/layer_detail.h"

namespace sturm {

namespace {

template <class Pixel>
auto first_in_row(const std::vector<Pixel>& pixels, int row) {
  return std::lower_bound(pixels.begin(), pixels.end(), row, [](const Pixel& p, int y) { return p.y < y; });
}

}  // namespace

CellBox box_of(std::span<const LayerEntry> entries, int side) {
  CellBox box{side, side, 0, 0};
  for (const LayerEntry& entry : entries) {
    const int x = static_cast<int>(entry.cell) % side, y = static_cast<int>(entry.cell) / side;
    box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), std::max(box.bottom, y + 1)};
  }
  return box;
}

void SplitWindow::split(const TileWindow& window) {
  window_ = window;
  left_ = std::max(0, window.left);
  top_ = std::max(0, window.top);
  right_ = std::min(width(), window.left + window.side);
  bottom_ = std::min(height(), window.top + window.side);
  const std::size_t cells = static_cast<std::size_t>(window.side) * static_cast<std::size_t>(window.side);
  pieces_.clear();
  pieces_.reserve(cells);
  entries_.reserve(2 * cells);
  find_details();
  collect_front();
  collect_hidden();
  share_out();
  collect_lamps();
}

/// A piece without coverage is left out.
void SplitWindow::collect(int x, int y, double vergence_D, float coverage, const float* rgb, const SurfaceSlope& slope,
                          const Detail* detail) {
  if (!(coverage > 0.0f)) return;
  const auto cell = static_cast<std::uint32_t>((y - window_.top) * window_.side + (x - window_.left));
  pieces_.push_back({bank_.place_of(vergence_D), {cell, coverage, rgb, slope.x, slope.y, detail}});
}

void SplitWindow::find_details() {
  details_.clear();
  if (!picture_.shows_detail) return;
  LayerDetail surface(picture_.radiance, picture_.vergence_D, picture_.coverage, picture_.jump_D, left_, right_, top_);
  for (int y = top_; y < bottom_; ++y) {
    const std::span<const Detail> row = surface.next_row();
    details_.insert(details_.end(), row.begin(), row.end());
  }
}

void SplitWindow::collect_front() {
  const Detail* detail = details_.empty() ? nullptr : details_.data();
  for (int y = top_; y < bottom_; ++y)
    for (int x = left_; x < right_; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width() + x;
      collect(x, y, picture_.vergence_D[i], picture_.coverage.empty() ? 1.0f : picture_.coverage[i],
              picture_.radiance.at(x, y),
              slopes_ ? surface_slope(picture_.vergence_D, width(), height(), x, y, picture_.jump_D) : SurfaceSlope{},
              detail);
      if (detail) ++detail;
    }
}

void SplitWindow::collect_hidden() {
  auto hidden = first_in_row(picture_.hidden, top_);
  for (; hidden != picture_.hidden.end() && hidden->y < bottom_; ++hidden)
    if (hidden->x >= left_ && hidden->x < right_)
      collect(hidden->x, hidden->y, hidden->vergence_D, hidden->coverage, hidden->rgb,
              slopes_ ? SurfaceSlope{hidden->slope_x, hidden->slope_y} : SurfaceSlope{}, &hidden->detail);
}

void SplitWindow::share_out() {
  first_.assign(bank_.planes_D().size() + 1, 0);
  for (const Piece& piece : pieces_) {
    ++first_[piece.place.plane + 1];
    if (piece.place.next_weight > 0.0f) ++first_[piece.place.plane + 2];
  }
  for (std::size_t plane = 1; plane < first_.size(); ++plane) first_[plane] += first_[plane - 1];
  entries_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const Piece& piece : pieces_) {
    LayerEntry& entry = entries_[next[piece.place.plane]++] = piece.entry;
    if (!(piece.place.next_weight > 0.0f)) continue;
    LayerEntry& behind = entries_[next[piece.place.plane + 1]++] = piece.entry;
    behind.weight *= piece.place.next_weight;
    entry.weight -= behind.weight;
  }
}

void SplitWindow::collect_lamps() {
  if (picture_.lamps.empty()) return;
  lamps_.resize(bank_.planes_D().size());
  for (std::vector<LampEntry>& of_plane : lamps_) of_plane.clear();
  for (auto lamp = first_in_row(picture_.lamps, window_.top);
       lamp != picture_.lamps.end() && lamp->y < window_.top + window_.side; ++lamp) {
    if (lamp->x < window_.left || lamp->x >= window_.left + window_.side) continue;
    const auto cell = static_cast<std::uint32_t>((lamp->y - window_.top) * window_.side + (lamp->x - window_.left));
    const auto [plane, next_weight] = bank_.place_of(lamp->vergence_D);
    lamps_[static_cast<std::size_t>(plane)].push_back({cell, 1.0f - next_weight, &*lamp});
    if (next_weight > 0.0f) lamps_[static_cast<std::size_t>(plane) + 1].push_back({cell, next_weight, &*lamp});
  }
}

}  // namespace sturm
