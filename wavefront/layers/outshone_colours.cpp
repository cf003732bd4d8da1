#include "wavefront/layers/outshone_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "wavefront/layers/brightness.h"

namespace sturm {

namespace {

using Rgb = std::array<float, 3>;

constexpr float close_enough = 1.0f / 256.0f;  // of the colours' brightness: two sides that fit together as well as any

class Outshone {
 public:
  Outshone(const LayeredPicture& picture, const std::vector<HiddenPixel>& outshone)
      : picture_(picture), outshone_(picture.vergence_D.size(), false) {
    for (const HiddenPixel& pixel : outshone) outshone_[index(pixel.x, pixel.y)] = true;
  }

  std::optional<Rgb> color(const HiddenPixel& pixel) const {
    Rgb sum{};
    float weights = 0.0f;
    for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}}) {
      const Side before = side_of(pixel, -dx, -dy), behind = side_of(pixel, dx, dy);
      if (!before.first || !behind.first) continue;
      const float weight = closeness(before, behind);
      const Rgb here = between(before, behind);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * here[c];
      weights += weight;
    }
    if (weights == 0.0f) return std::nullopt;
    for (float& value : sum) value = std::max(0.0f, value / weights);
    return sum;
  }

 private:
  /// The first pixel in a direction that is no lamp, with the next one.
  struct Side {
    const float *first = nullptr, *second = nullptr;  // null: not on the same surface
    int distance = 0;                                 // of the first
  };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.radiance.width) +
           static_cast<std::size_t>(x);
  }

  bool on_surface(int x, int y, double vergence_D) const {
    const Image& image = picture_.radiance;
    return x >= 0 && y >= 0 && x < image.width && y < image.height &&
           std::abs(picture_.vergence_D[index(x, y)] - vergence_D) <= picture_.jump_D;
  }

  Side side_of(const HiddenPixel& pixel, int dx, int dy) const {
    Side side;
    int x = pixel.x, y = pixel.y;
    do x += dx, y += dy, ++side.distance;
    while (on_surface(x, y, pixel.vergence_D) && outshone_[index(x, y)]);
    if (!on_surface(x, y, pixel.vergence_D)) return side;
    side.first = picture_.radiance.at(x, y);
    if (on_surface(x + dx, y + dy, pixel.vergence_D) && !outshone_[index(x + dx, y + dy)])
      side.second = picture_.radiance.at(x + dx, y + dy);
    return side;
  }

  static float closeness(const Side& before, const Side& behind) {
    constexpr float least = 1e-9f;  // for black
    float apart = std::max(least, close_enough * (brightness_of(before.first) + brightness_of(behind.first)));
    for (int c = 0; c < 3; ++c) apart = std::max(apart, std::abs(before.first[c] - behind.first[c]));
    const auto distance = static_cast<float>(before.distance + behind.distance);
    return 1.0f / (apart * apart * distance * distance);
  }

  /// By a line, or a cubic where two pixels of either side are there.
  static Rgb between(const Side& before, const Side& behind) {
    const auto p = static_cast<float>(before.distance), q = static_cast<float>(behind.distance);
    Rgb here;
    for (std::size_t c = 0; c < 3; ++c) {
      const float rise = (behind.first[c] - before.first[c]) / (p + q);
      here[c] = before.first[c] + p * rise;
      if (!before.second || !behind.second) continue;
      float left = before.first[c] - before.second[c], right = behind.second[c] - behind.first[c];
      const float most_left = std::abs(right) + 2.0f * std::abs(rise),
                  most_right = std::abs(left) + 2.0f * std::abs(rise);
      left = std::clamp(left, -most_left, most_left);
      right = std::clamp(right, -most_right, most_right);
      // The cubic through −p − 1, −p, q and q + 1, from the line: of what the outer steps have more than it.
      const float width = p + q;
      here[c] += p * q / ((width + 1.0f) * (width + 2.0f)) * ((q + 1.0f) * (left - rise) - (p + 1.0f) * (right - rise));
    }
    return here;
  }

  const LayeredPicture& picture_;
  std::vector<bool> outshone_;
};

}  // namespace

void guess_outshone(const LayeredPicture& picture, std::vector<HiddenPixel>& outshone) {
  const Outshone surfaces(picture, outshone);
  for (HiddenPixel& pixel : outshone)
    if (const auto color = surfaces.color(pixel)) std::copy_n(color->begin(), 3, pixel.rgb);
}

}  // namespace sturm
