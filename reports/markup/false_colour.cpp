#include "reports/markup/false_colour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <stdexcept>

namespace sturm {

namespace {

constexpr std::uint32_t inferno[] = {
    0x000004, 0x02020c, 0x050417, 0x0a0722, 0x10092d, 0x160b39, 0x1e0c45, 0x260c51, 0x2f0a5b, 0x380962, 0x400a67,
    0x490b6a, 0x510e6c, 0x59106e, 0x61136e, 0x69166e, 0x71196e, 0x781c6d, 0x801f6c, 0x88226a, 0x902568, 0x982766,
    0xa02a63, 0xa82e5f, 0xb0315b, 0xb73557, 0xbf3952, 0xc63d4d, 0xcc4248, 0xd34743, 0xd94d3d, 0xdf5337, 0xe45a31,
    0xe9612b, 0xed6925, 0xf1711f, 0xf47918, 0xf78212, 0xf98b0b, 0xfa9407, 0xfb9d07, 0xfca60c, 0xfcb014, 0xfbba1f,
    0xfac42a, 0xf8cd37, 0xf6d746, 0xf4e156, 0xf2ea69, 0xf2f27d, 0xf5f992, 0xfcffa4};

constexpr std::uint32_t blue_to_red[] = {0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xf7f7f7,
                                         0xfddbc7, 0xf4a582, 0xd6604d, 0xb2182b, 0x67001f};

DisplayColour interpolate(std::span<const std::uint32_t> table, double t) {
  const double position = std::clamp(t, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(position), table.size() - 2);
  const double fraction = position - static_cast<double>(low);
  DisplayColour colour;
  for (int c = 0; c < 3; ++c) {
    const int shift = 16 - 8 * c;
    const double a = (table[low] >> shift) & 0xff, b = (table[low + 1] >> shift) & 0xff;
    colour[c] = static_cast<float>(std::round(a + (b - a) * fraction) / 255.0);
  }
  return colour;
}

template <typename ColourOf>
Image coloured(const Image& values, ColourOf colour_of) {
  if (values.channels != 1) throw std::invalid_argument("false colour needs an image of one channel");
  Image result(values.width, values.height, 3);
  for (std::size_t i = 0; i < values.pixels.size(); ++i) {
    const double value = values.pixels[i];
    const DisplayColour colour = std::isfinite(value) ? colour_of(value) : not_finite_colour();
    std::copy(colour.begin(), colour.end(), result.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return result;
}

}  // namespace

DisplayColour sequential_colour(double t) {
  return interpolate(inferno, t);
}

DisplayColour diverging_colour(double t) {
  return interpolate(blue_to_red, 0.5 + 0.5 * t);
}

DisplayColour not_finite_colour() {
  return {0.0f, 1.0f, 0.0f};
}

double position_on(const SequentialScale& scale, double value) {
  const double relative = value / scale.peak;
  if (scale.decades == 0.0) return std::clamp(relative, 0.0, 1.0);
  if (relative <= 0.0) return 0.0;
  return std::clamp(1.0 + std::log10(relative) / scale.decades, 0.0, 1.0);
}

Image sequential_false_colour(const Image& values, const SequentialScale& scale) {
  return coloured(values, [&](double value) { return sequential_colour(position_on(scale, value)); });
}

Image diverging_false_colour(const Image& values, double limit) {
  return coloured(values, [&](double value) { return diverging_colour(value / limit); });
}

std::string hex_colour(const DisplayColour& colour) {
  char buffer[8];
  std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x", static_cast<int>(std::lround(255 * colour[0])),
                static_cast<int>(std::lround(255 * colour[1])), static_cast<int>(std::lround(255 * colour[2])));
  return buffer;
}

}  // namespace sturm
