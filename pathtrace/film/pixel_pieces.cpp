#include "pathtrace/film/pixel_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sturm {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr std::size_t most_pieces = 8;
constexpr float same_way = 0.906f;  // cos 25°

/// Variance of the mean of `count` values from their sum and the sum of their squares. Of a single one nothing is
/// known: as uncertain as it is bright.
Vector3f variance_of_mean(const Vector3d& sum, const Vector3d& squares, int count) {
  const Vector3d square = (sum / count).cwiseAbs2();
  if (count < 2) return square.cast<float>();
  return ((squares / count - square).cwiseMax(0.0) / (count - 1)).cast<float>();
}

}  // namespace

void PixelPieces::Piece::cover_with(const SeenSurface& seen) {
  position += seen.point.cast<double>();
  places += seen.place;
  place_squares += seen.place * seen.place.transpose();
  ++cover;
}

void PixelPieces::add(const SeenSurface& seen) {
  Piece* piece = existing(seen);
  if (!piece)
    piece = &pieces_.emplace_back(
        Piece{seen.point, seen.normal, seen.pixel_size, seen.surroundings, seen.emits, seen.lambertian});
  const Vector3d direct = seen.direct.cast<double>(), indirect = seen.radiance.cast<double>() - direct;
  piece->normals += seen.normal.cast<double>();
  piece->albedo += seen.albedo.cast<double>();
  piece->direct += direct;
  piece->direct_squares += direct.cwiseAbs2();
  piece->indirect += indirect;
  piece->indirect_squares += indirect.cwiseAbs2();
  ++piece->count;
  piece->cover_with(seen);
}

bool PixelPieces::add_cover(const SeenSurface& seen) {
  Piece* piece = existing(seen);
  if (piece) piece->cover_with(seen);
  return piece;
}

bool PixelPieces::emits() const {
  return std::any_of(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.emits; });
}

bool PixelPieces::are_one_lamp() const {
  return pieces_.size() == 1 && pieces_.front().emits;
}

void PixelPieces::append_to(std::vector<Fragment>& list, int samples) const {
  for (const Piece& piece : pieces_) list.push_back(piece.fragment(samples));
}

/// Where there is no room for more, the piece whose plane is nearest takes it.
PixelPieces::Piece* PixelPieces::existing(const SeenSurface& seen) {
  Piece* nearest = nullptr;
  float nearest_distance = std::numeric_limits<float>::infinity();
  for (Piece& p : pieces_) {
    if (p.surroundings != seen.surroundings) continue;
    const float distance = p.surroundings ? 0.0f : std::abs(p.normal.dot(seen.point - p.point)) / p.pixel_size;
    if (p.surroundings || (p.emits == seen.emits && p.normal.dot(seen.normal) > same_way && distance <= 1.0f))
      return &p;
    if (distance < nearest_distance) nearest = &p, nearest_distance = distance;
  }
  if (pieces_.size() < most_pieces) return nullptr;
  return nearest ? nearest : &pieces_.front();
}

Fragment PixelPieces::Piece::fragment(int samples) const {
  Fragment f;
  const Vector3d mean = position / cover;
  f.position = (surroundings ? Vector3d(mean.normalized()) : mean).cast<float>();
  f.normal = surroundings ? Vector3f(Vector3f::Zero()) : Vector3f(normals.normalized().cast<float>());
  f.radiance = ((direct + indirect) / count).cast<float>();
  f.direct = (direct / count).cast<float>();
  f.albedo = (albedo / count).cast<float>();
  f.direct_variance = variance_of_mean(direct, direct_squares, count);
  f.indirect_variance = variance_of_mean(indirect, indirect_squares, count);
  f.share = static_cast<float>(static_cast<double>(cover) / samples);
  const Eigen::Vector2d middle = places / cover;
  const Eigen::Matrix2d spread = place_squares / cover - middle * middle.transpose();
  f.middle = middle.cast<float>();
  f.spread =
      Vector3f(static_cast<float>(spread(0, 0)), static_cast<float>(spread(0, 1)), static_cast<float>(spread(1, 1)));
  f.surroundings = surroundings;
  f.emits = emits;
  f.lambertian = lambertian;
  return f;
}

}  // namespace sturm
