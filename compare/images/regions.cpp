#include "compare/images/regions.h"

#include <algorithm>
#include <cmath>

#include "compare/metrics/luma.h"
#include "io/files/error.h"
#include "lensmodel/symmetric2.h"

namespace sturm {

namespace {

constexpr float sharp_limit_px = 1.0f;
constexpr double edge_threshold = 0.05;
constexpr double edge_margin_px = 2.0, widest_edge_px = 32.0;

template <class Predicate>
Image mask_where(const Image& layer, const Predicate& inside) {
  Image mask(layer.width, layer.height, 1);
  for (std::size_t i = 0; i < mask.pixels.size(); ++i) mask.pixels[i] = inside(i) ? 1.0f : 0.0f;
  return mask;
}

double reciprocal(const Image& depth, int x, int y) {
  return 1.0 / *depth.at(x, y);  // 0 where nothing was hit
}

/// Whether the reciprocal depth bends between (x, y) and its neighbours at ±(dx, dy).
bool bends(const Image& depth, int x, int y, int dx, int dy) {
  const double before = reciprocal(depth, x - dx, y - dy), here = reciprocal(depth, x, y),
               after = reciprocal(depth, x + dx, y + dy);
  return std::abs(before - 2.0 * here + after) > edge_threshold * std::max({before, here, after});
}

bool is_edge(const Image& depth, int x, int y) {
  const bool inside_x = x > 0 && x + 1 < depth.width, inside_y = y > 0 && y + 1 < depth.height;
  return (inside_x && bends(depth, x, y, 1, 0)) || (inside_y && bends(depth, x, y, 0, 1));
}

void paint_disc(Image& mask, int centre_x, int centre_y, double radius) {
  const int reach = static_cast<int>(radius);
  for (int y = std::max(0, centre_y - reach); y <= std::min(mask.height - 1, centre_y + reach); ++y)
    for (int x = std::max(0, centre_x - reach); x <= std::min(mask.width - 1, centre_x + reach); ++x)
      if ((x - centre_x) * (x - centre_x) + (y - centre_y) * (y - centre_y) <= radius * radius) *mask.at(x, y) = 1.0f;
}

void require_layer(const std::optional<Image>& layer, const Image& picture, const std::string& name) {
  if (layer && (layer->width != picture.width || layer->height != picture.height || layer->channels != 1))
    throw InputError("", "", "a layer " + name + " of another size", "the size of the pictures and one channel");
}

}  // namespace

std::size_t Region::pixels() const {
  return static_cast<std::size_t>(std::count(mask.pixels.begin(), mask.pixels.end(), 1.0f));
}

Image blur_semi_axis_px(const Image& depth, const Eye& eye, double accommodation_D, double pixel_slope) {
  const Eigen::Matrix2d slopes = eye.slope_matrix(accommodation_D).matrix();
  Image blur(depth.width, depth.height, 1);
  for (std::size_t i = 0; i < blur.pixels.size(); ++i) {
    const double vergence = 1.0 / depth.pixels[i];
    blur.pixels[i] = static_cast<float>(
        eye.pupil_radius_m * singular_values(vergence * Eigen::Matrix2d::Identity() + slopes).large / pixel_slope);
  }
  return blur;
}

Image occlusion_edges(const Image& depth, const Image* blur_px) {
  Image mask(depth.width, depth.height, 1);
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      if (!is_edge(depth, x, y)) continue;
      const double blur = blur_px ? *blur_px->at(x, y) : 0.0;
      paint_disc(mask, x, y, std::min(widest_edge_px, edge_margin_px + blur));
    }
  return mask;
}

std::vector<Region> regions_of(const Image& test, const Image& reference, double exposure, const RegionLayers& layers) {
  require_layer(layers.depth, reference, "depth");
  require_layer(layers.blur_px, reference, "of blur");
  std::vector<Region> regions;
  if (layers.blur_px) {
    const std::vector<float>& blur = layers.blur_px->pixels;
    regions.push_back(
        {"in_focus", mask_where(*layers.blur_px, [&](std::size_t i) { return blur[i] <= sharp_limit_px; })});
    regions.push_back(
        {"blurred", mask_where(*layers.blur_px, [&](std::size_t i) { return blur[i] > sharp_limit_px; })});
  }
  if (layers.depth)
    regions.push_back({"occlusion_edges", occlusion_edges(*layers.depth, layers.blur_px ? &*layers.blur_px : nullptr)});
  const std::vector<double> a = luma(test), b = luma(reference);
  regions.push_back(
      {"highlights", mask_where(reference, [&](std::size_t i) { return exposure * std::max(a[i], b[i]) > 1.0; })});
  return regions;
}

}  // namespace sturm
