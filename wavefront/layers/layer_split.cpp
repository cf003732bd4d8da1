#include "wavefront/layers/layer_split.h"

#include <algorithm>

namespace sturm {

namespace {

struct Piece {
  KernelBank::Place place;
  LayerEntry entry;  // its weight is the whole coverage
};

template <class Pixel>
auto first_in_row(const std::vector<Pixel>& pixels, int row) {
  return std::lower_bound(pixels.begin(), pixels.end(), row, [](const Pixel& p, int y) { return p.y < y; });
}

/// Collects the pieces of a window; those without coverage are left out.
class WindowPieces {
 public:
  WindowPieces(const LayeredPicture& picture, const KernelBank& bank, const TileWindow& window)
      : picture_(picture),
        bank_(bank),
        window_(window),
        width_(picture.radiance.width),
        height_(picture.radiance.height),
        slopes_(bank.parts().size() > 1) {
    const int first_row = std::max(0, window.top), end_row = std::min(height_, window.top + window.side);
    pieces_.reserve(static_cast<std::size_t>(window.side) * window.side);
    for (int y = first_row; y < end_row; ++y) add_front(y);
    add_hidden(first_row, end_row);
  }

  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  void add(int x, int y, double vergence_D, float coverage, const float* rgb, const SurfaceSlope& slope,
           const Detail* detail) {
    if (!(coverage > 0.0f)) return;
    const auto cell = static_cast<std::uint32_t>((y - window_.top) * window_.side + (x - window_.left));
    pieces_.push_back({bank_.place_of(vergence_D), {cell, coverage, rgb, slope.x, slope.y, detail}});
  }

  void add_front(int y) {
    const int end = std::min(width_, window_.left + window_.side);
    for (int x = std::max(0, window_.left); x < end; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width_ + x;
      add(x, y, picture_.vergence_D[i], picture_.coverage.empty() ? 1.0f : picture_.coverage[i],
          picture_.radiance.at(x, y),
          slopes_ ? surface_slope(picture_.vergence_D, width_, height_, x, y, picture_.jump_D) : SurfaceSlope{},
          picture_.detail.empty() ? nullptr : &picture_.detail[i]);
    }
  }

  void add_hidden(int first_row, int end_row) {
    auto hidden = first_in_row(picture_.hidden, first_row);
    for (; hidden != picture_.hidden.end() && hidden->y < end_row; ++hidden)
      if (hidden->x >= window_.left && hidden->x < window_.left + window_.side)
        add(hidden->x, hidden->y, hidden->vergence_D, hidden->coverage, hidden->rgb,
            slopes_ ? SurfaceSlope{hidden->slope_x, hidden->slope_y} : SurfaceSlope{}, &hidden->detail);
  }

  const LayeredPicture& picture_;
  const KernelBank& bank_;
  const TileWindow& window_;
  int width_, height_;
  bool slopes_;
  std::vector<Piece> pieces_;
};

}  // namespace

CellBox box_of(std::span<const LayerEntry> entries, int side) {
  CellBox box{side, side, 0, 0};
  for (const LayerEntry& entry : entries) {
    const int x = static_cast<int>(entry.cell) % side, y = static_cast<int>(entry.cell) / side;
    box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), std::max(box.bottom, y + 1)};
  }
  return box;
}

SplitWindow::SplitWindow(const LayeredPicture& picture, const KernelBank& bank, const TileWindow& window)
    : first_(bank.planes_D().size() + 1, 0) {
  const WindowPieces window_pieces(picture, bank, window);
  for (const Piece& piece : window_pieces.pieces()) {
    ++first_[piece.place.plane + 1];
    if (piece.place.next_weight > 0.0f) ++first_[piece.place.plane + 2];
  }
  for (std::size_t plane = 1; plane < first_.size(); ++plane) first_[plane] += first_[plane - 1];
  entries_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const Piece& piece : window_pieces.pieces()) {
    LayerEntry& entry = entries_[next[piece.place.plane]++] = piece.entry;
    if (!(piece.place.next_weight > 0.0f)) continue;
    LayerEntry& behind = entries_[next[piece.place.plane + 1]++] = piece.entry;
    behind.weight *= piece.place.next_weight;
    entry.weight -= behind.weight;
  }
  if (!picture.lamps.empty()) add_lamps(picture, bank, window);
}

void SplitWindow::add_lamps(const LayeredPicture& picture, const KernelBank& bank, const TileWindow& window) {
  lamps_.resize(bank.planes_D().size());
  for (auto lamp = first_in_row(picture.lamps, window.top);
       lamp != picture.lamps.end() && lamp->y < window.top + window.side; ++lamp) {
    if (lamp->x < window.left || lamp->x >= window.left + window.side) continue;
    const auto cell = static_cast<std::uint32_t>((lamp->y - window.top) * window.side + (lamp->x - window.left));
    const auto [plane, next_weight] = bank.place_of(lamp->vergence_D);
    lamps_[static_cast<std::size_t>(plane)].push_back({cell, 1.0f - next_weight, &*lamp});
    if (next_weight > 0.0f) lamps_[static_cast<std::size_t>(plane) + 1].push_back({cell, next_weight, &*lamp});
  }
}

}  // namespace sturm
