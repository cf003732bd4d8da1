#include "conoid/sharp_lookup.h"

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
    : view_(view), oversampling_(oversampling), pixel_slope_(static_cast<float>(pixel_slope / oversampling)), tell_lamps_(tell_lamps) {}

Eigen::Vector2i SharpLookup::pixel_of(const Eigen::Vector2d& place) const {
  return {static_cast<int>(std::floor(place.x() * oversampling_)), static_cast<int>(std::floor(place.y() * oversampling_))};
}

std::optional<Vector3f> SharpLookup::find(const MetPoint& point) const {
  const Eigen::Vector2i at = pixel_of(point.place);
  if (at.x() < 0 || at.y() < 0 || at.x() >= view_.width || at.y() >= view_.height) return std::nullopt;
  const float pixel = pixel_slope_ * point.distance;
  const auto off_plane = [&](const Fragment& f) {
    if (f.surroundings != point.surroundings || (tell_lamps_ && f.emits != point.emits)) return std::numeric_limits<float>::infinity();
    return point.surroundings ? 0.0f : std::abs(f.normal.dot(point.position - f.position));
  };
  const auto fragments = view_.at(at.x(), at.y());
  if (fragments.size() == 1) return off_plane(fragments[0]) <= pixel ? std::optional(fragments[0].radiance) : std::nullopt;
  float best = pixel;
  for (const Fragment& f : fragments) best = std::min(best, off_plane(f));
  // Several fragments may lie on one plane: the pixel's mean over them.
  Vector3f sum = Vector3f::Zero();
  float share = 0.0f;
  for (const Fragment& f : fragments) {
    if (!(off_plane(f) <= std::min(best + 0.05f * pixel, pixel))) continue;
    sum += f.share * f.radiance;
    share += f.share;
  }
  if (!(share > 0.0f)) return std::nullopt;
  return Vector3f(sum / share);
}

UnseenCell SharpLookup::cell_of(const MetPoint& point) const {
  const Eigen::Vector2i at = pixel_of(point.place);
  const float step = std::floor(static_cast<float>(steps_per_e) * std::log(point.distance));
  return {at.x(), at.y(), point.surroundings ? UnseenCell::at_infinity : static_cast<std::int32_t>(step),
          tell_lamps_ && point.emits ? 1 : 0};
}

}  // namespace sturm
