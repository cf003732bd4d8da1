#include "io/images/tone_map.h"

#include <algorithm>
#include <cmath>

#include "io/images/changed_colours.h"

namespace sturm {

float linear_to_srgb(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float srgb_to_linear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Image srgb_to_linear(const Image& encoded) {
  return changed_colours(encoded, [](float value) { return srgb_to_linear(value); });
}

Image to_display(const Image& linear, double exposure) {
  Image display = linear;
  for (float& value : display.pixels)
    value = linear_to_srgb(static_cast<float>(std::clamp(exposure * value, 0.0, 1.0)));
  return display;
}

Image clamped(Image image) {
  for (float& value : image.pixels) value = std::clamp(value, 0.0f, 1.0f);
  return image;
}

}  // namespace sturm
