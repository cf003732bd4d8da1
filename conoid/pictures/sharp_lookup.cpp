#include "conoid/pictures/sharp_lookup.h"

#include <algorithm>
#include <cmath>

namespace sturm {

using Eigen::Vector3f;

namespace {
constexpr double steps_per_e = 64.0;  // of the distance: 1.6 % each
}

std::uint64_t UnseenCell::key() const {  // FNV-1a over the four numbers
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const std::int32_t v : {x, y, depth, kind}) hash = (hash ^ static_cast<std::uint32_t>(v)) * 0x100000001b3ull;
  return hash ^ (hash >> 29);
}

double UnseenCell::distance() const {
  return depth == at_infinity ? std::numeric_limits<double>::infinity() : std::exp((depth + 0.5) / steps_per_e);
}

SharpLookup::SharpLookup(const FragmentImage& view, int oversampling, double pixel_slope, bool tell_lamps)
    : width_(view.width),
      height_(view.height),
      oversampling_(oversampling),
      pixel_slope_(static_cast<float>(pixel_slope / oversampling)),
      tell_lamps_(tell_lamps),
      first_(view.first) {
  known_.reserve(view.fragments.size());
  shares_.reserve(view.fragments.size());
  for (const Fragment& f : view.fragments) {
    const double offset = f.surroundings ? 0.0 : f.normal.cast<double>().dot(f.position.cast<double>());
    known_.push_back({f.normal, static_cast<float>(offset), f.radiance, kind_of(f.surroundings, f.emits)});
    shares_.push_back(f.share);
  }
}

Eigen::Vector2i SharpLookup::pixel_of(const Eigen::Vector2d& place) const {
  return {static_cast<int>(std::floor(place.x() * oversampling_)),
          static_cast<int>(std::floor(place.y() * oversampling_))};
}

std::optional<Vector3f> SharpLookup::find(const MetPoint& point) const {
  const Eigen::Vector2i at = pixel_of(point.place);
  if (at.x() < 0 || at.y() < 0 || at.x() >= width_ || at.y() >= height_) return std::nullopt;
  const float pixel = pixel_slope_ * point.distance;
  const Kind kind = kind_of(point.surroundings, point.emits);
  const auto off_plane = [&](const Known& f) {  // the surroundings have no normal: zero
    const bool fits = f.kind == kind || (!tell_lamps_ && kind == Kind::surface && f.kind == Kind::lamp);
    return fits ? std::abs(f.normal.dot(point.position) - f.offset) : std::numeric_limits<float>::infinity();
  };
  const std::size_t index =
      static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(at.x());
  const std::uint32_t first = first_[index], end = first_[index + 1];
  if (end == first + 1) return off_plane(known_[first]) <= pixel ? std::optional(known_[first].radiance) : std::nullopt;
  float best = pixel;
  for (std::uint32_t i = first; i < end; ++i) best = std::min(best, off_plane(known_[i]));
  // Several fragments may lie on one plane: the pixel's mean over them.
  Vector3f sum = Vector3f::Zero();
  float share = 0.0f;
  for (std::uint32_t i = first; i < end; ++i) {
    if (!(off_plane(known_[i]) <= std::min(best + 0.05f * pixel, pixel))) continue;
    sum += shares_[i] * known_[i].radiance;
    share += shares_[i];
  }
  if (!(share > 0.0f)) return std::nullopt;
  return Vector3f(sum / share);
}

UnseenCell SharpLookup::cell_of(const MetPoint& point) const {
  const Eigen::Vector2i at = pixel_of(point.place);
  const float step = std::floor(static_cast<float>(steps_per_e) * std::log(point.distance));
  return {at.x(), at.y(), point.surroundings ? UnseenCell::at_infinity : static_cast<std::int32_t>(step),
          point.emits ? UnseenCell::lamp : 0};
}

}  // namespace sturm
