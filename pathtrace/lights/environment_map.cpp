#include "pathtrace/lights/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pathtrace/sampling/vector_math.h"

namespace sturm {

namespace {
constexpr float two_pi = 2.0f * std::numbers::pi_v<float>;
}

EnvironmentMap::EnvironmentMap(std::shared_ptr<const Image> picture, const Eigen::Vector3f& scale, float rotation)
    : picture_(std::move(picture)), scale_(scale), rotation_(rotation) {
  const int width = picture_->width, height = picture_->height;
  std::vector<double> row_weights, weights(static_cast<std::size_t>(width));
  edge_cosine_.push_back(1.0f);
  for (int y = 0; y < height; ++y) {
    edge_cosine_.push_back(y + 1 == height ? -1.0f : static_cast<float>(std::cos(std::numbers::pi * (y + 1) / height)));
    double sum = 0.0;
    for (int x = 0; x < width; ++x)
      sum += weights[static_cast<std::size_t>(x)] = static_cast<double>(luminance(radiance(Pixel{x, y})));
    columns_.emplace_back(weights);
    row_weights.push_back(sum * static_cast<double>(edge_cosine_[y] - edge_cosine_[y + 1]));
  }
  rows_ = AliasTable(row_weights);
}

EnvironmentMap::Pixel EnvironmentMap::pixel(const Eigen::Vector3f& direction) const {
  const Eigen::Vector3f w = direction.normalized();
  const float turn = (std::atan2(w.x(), -w.z()) - rotation_) / two_pi + 0.5f;
  const int x = static_cast<int>((turn - std::floor(turn)) * static_cast<float>(picture_->width));
  // By the stored edges, so that a sampled direction falls into the row that it was sampled from.
  const auto below = std::upper_bound(edge_cosine_.begin() + 1, edge_cosine_.end() - 1, w.y(),
                                      [](float c, float edge) { return c >= edge; });
  return {std::min(x, picture_->width - 1), static_cast<int>(below - edge_cosine_.begin()) - 1};
}

Eigen::Vector3f EnvironmentMap::radiance(Pixel at) const {
  const float* p = picture_->at(at.x, at.y);
  return scale_.cwiseProduct(Eigen::Vector3f(p[0], p[1], p[2]));
}

float EnvironmentMap::pdf(Pixel at) const {
  const float solid_angle =
      two_pi / static_cast<float>(picture_->width) * (edge_cosine_[at.y] - edge_cosine_[at.y + 1]);
  return rows_.probability(at.y) * columns_[static_cast<std::size_t>(at.y)].probability(at.x) / solid_angle;
}

Eigen::Vector3f EnvironmentMap::radiance(const Eigen::Vector3f& direction) const {
  return radiance(pixel(direction));
}

float EnvironmentMap::pdf(const Eigen::Vector3f& direction) const {
  return pdf(pixel(direction));
}

EnvironmentSample EnvironmentMap::sample(float u, float v) const {
  const int y = rows_.choose(v), x = columns_[static_cast<std::size_t>(y)].choose(u);
  const float cosine = edge_cosine_[y] + v * (edge_cosine_[y + 1] - edge_cosine_[y]),
              sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
  const float azimuth = ((static_cast<float>(x) + u) / static_cast<float>(picture_->width) - 0.5f) * two_pi + rotation_;
  return {{sine * std::sin(azimuth), cosine, -sine * std::cos(azimuth)}, radiance(Pixel{x, y}), pdf(Pixel{x, y})};
}

}  // namespace sturm
