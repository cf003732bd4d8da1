#include "stages/surfaces_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "wavefront/layers/ray_kernels.h"

namespace sturm {

namespace {

/// Pixels beyond the border of a picture.
int beyond(const SurfacePiece& piece, int width, int height) {
  return std::max({0, -piece.x, -piece.y, piece.x - width + 1, piece.y - height + 1});
}

class Surfaces {
 public:
  Surfaces(std::vector<SurfacePiece> pieces, int width, int height, double jump_D)
      : pieces_(std::move(pieces)), inner_width_(width), inner_height_(height), jump_D_(jump_D) {
    std::erase_if(pieces_, [&](const SurfacePiece& p) { return beyond(p, width, height) > largest_kernel_radius_px; });
    for (const SurfacePiece& piece : pieces_) margin_ = std::max(margin_, beyond(piece, width, height));
    width_ = width + 2 * margin_;
    height_ = height + 2 * margin_;
    for (SurfacePiece& piece : pieces_) {
      piece.x += margin_;
      piece.y += margin_;
    }
    std::stable_sort(pieces_.begin(), pieces_.end(), [](const SurfacePiece& a, const SurfacePiece& b) {
      return std::tuple(a.y, a.x, -a.vergence_D) < std::tuple(b.y, b.x, -b.vergence_D);
    });
    first_.assign(static_cast<std::size_t>(width_) * height_ + 1, 0);
    for (const SurfacePiece& piece : pieces_) ++first_[index(piece.x, piece.y) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  }

  SurfacesPicture picture() const {
    SurfacesPicture result;
    result.picture.radiance = Image(width_, height_, 3);
    result.picture.vergence_D.resize(first_.size() - 1);
    result.picture.coverage.assign(first_.size() - 1, 0.0f);
    result.picture.jump_D = jump_D_;
    result.margin_px = margin_;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) add_pixel(x, y, result.picture);
    return result;
  }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  std::span<const SurfacePiece> at(int x, int y) const {
    return {pieces_.data() + first_[index(x, y)], pieces_.data() + first_[index(x, y) + 1]};
  }

  void add_pixel(int x, int y, LayeredPicture& picture) const {
    const auto here = at(x, y);
    if (here.empty()) {
      add_unknown(x, y, picture);
      return;
    }
    picture.vergence_D[index(x, y)] = here[0].vergence_D;
    picture.coverage[index(x, y)] = std::min(1.0f, here[0].coverage);
    Eigen::Map<Eigen::Vector3f>(picture.radiance.at(x, y)) = here[0].radiance;
    for (const SurfacePiece& piece : here.subspan(1))
      picture.hidden.push_back({x,
                                y,
                                piece.vergence_D,
                                std::min(1.0f, piece.coverage),
                                {piece.radiance.x(), piece.radiance.y(), piece.radiance.z()},
                                slope(piece, 1, 0),
                                slope(piece, 0, 1)});
  }

  /// Nothing is seen there, but the picture's surfaces have no edge.
  void add_unknown(int x, int y, LayeredPicture& picture) const {
    const auto border =
        at(std::clamp(x, margin_, margin_ + inner_width_ - 1), std::clamp(y, margin_, margin_ + inner_height_ - 1));
    if (border.empty()) return;
    picture.vergence_D[index(x, y)] = border[0].vergence_D;
    Eigen::Map<Eigen::Vector3f>(picture.radiance.at(x, y)) = border[0].radiance;
  }

  /// The vergence of the same surface in another pixel, if it is known there.
  std::optional<double> neighbour(const SurfacePiece& piece, int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return std::nullopt;
    std::optional<double> nearest;
    for (const SurfacePiece& other : at(x, y))
      if (std::abs(other.vergence_D - piece.vergence_D) <= jump_D_ &&
          (!nearest || std::abs(other.vergence_D - piece.vergence_D) < std::abs(*nearest - piece.vergence_D)))
        nearest = other.vergence_D;
    return nearest;
  }

  /// Change of the vergence from pixel to pixel.
  float slope(const SurfacePiece& piece, int dx, int dy) const {
    const auto before = neighbour(piece, piece.x - dx, piece.y - dy),
               after = neighbour(piece, piece.x + dx, piece.y + dy);
    const double step = (before ? 1.0 : 0.0) + (after ? 1.0 : 0.0);
    if (step == 0.0) return 0.0f;
    return static_cast<float>((after.value_or(piece.vergence_D) - before.value_or(piece.vergence_D)) / step);
  }

  std::vector<SurfacePiece> pieces_;
  int inner_width_, inner_height_;
  double jump_D_;
  int margin_ = 0, width_ = 0, height_ = 0;
  std::vector<std::size_t> first_;  // of each pixel, and one more
};

}  // namespace

SurfacesPicture surfaces_picture(std::vector<SurfacePiece> pieces, int width, int height, double jump_D) {
  return Surfaces(std::move(pieces), width, height, jump_D).picture();
}

Image without_margin(const Image& seen, int margin_px, int oversampling) {
  const int n = oversampling;
  Image inner((seen.width - 2 * margin_px) / n, (seen.height - 2 * margin_px) / n, seen.channels);
  for (int y = 0; y < inner.height; ++y)
    for (int x = 0; x < inner.width; ++x)
      for (int k = 0; k < n * n; ++k) {
        const float* from = seen.at(margin_px + x * n + k % n, margin_px + y * n + k / n);
        for (int c = 0; c < seen.channels; ++c) inner.at(x, y)[c] += from[c] / static_cast<float>(n * n);
      }
  return inner;
}

}  // namespace sturm
