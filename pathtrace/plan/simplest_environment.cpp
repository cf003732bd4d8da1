#include "pathtrace/plan/simplest_environment.h"

#include <algorithm>

namespace sturm {

namespace {

/// The one value of a picture, if it has but one.
std::optional<Eigen::Vector3f> only_value(const Image& picture) {
  const Eigen::Vector3f first = Eigen::Map<const Eigen::Vector3f>(picture.pixels.data());
  for (std::size_t i = 3; i < picture.pixels.size(); i += 3)
    if (Eigen::Map<const Eigen::Vector3f>(picture.pixels.data() + i) != first) return std::nullopt;
  return first;
}

}  // namespace

std::optional<Environment> simplest_environment(const std::optional<Environment>& environment) {
  if (!environment) return std::nullopt;
  Environment simplest = *environment;
  if (simplest.map) {
    const std::optional<Eigen::Vector3f> value = only_value(*simplest.map);
    if (!value) return environment;
    simplest = {simplest.radiance.cwiseProduct(*value), nullptr, 0.0f};
  }
  if (!(simplest.radiance.maxCoeff() > 0.0f)) return std::nullopt;
  return simplest;
}

std::optional<Environment> sampled_environment(const std::optional<Environment>& environment) {
  if (!environment || environment->map) return environment;
  auto pixel = std::make_shared<Image>(1, 1, 3);
  std::fill(pixel->pixels.begin(), pixel->pixels.end(), 1.0f);
  return Environment{environment->radiance, std::move(pixel), 0.0f};
}

}  // namespace sturm
