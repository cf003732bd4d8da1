#include "wavefront/layers/brightness.h"

#include <vector>

namespace sturm {

float bright_level(const Image& radiance, float medians) {
  constexpr std::size_t one_in = 20;
  std::vector<float> brightness(radiance.pixels.size() / 3);
  for (std::size_t i = 0; i < brightness.size(); ++i) brightness[i] = brightness_of(&radiance.pixels[3 * i]);
  const auto middle = brightness.begin() + static_cast<std::ptrdiff_t>(brightness.size() / 2),
             high = brightness.end() - 1 - static_cast<std::ptrdiff_t>(brightness.size() / one_in);
  std::nth_element(brightness.begin(), middle, brightness.end());
  const float median = *middle;
  std::nth_element(brightness.begin(), high, brightness.end());
  return std::max(medians * median, *high);
}

}  // namespace sturm
