#include "wavefront/layers/guessed_background.h"

#include <algorithm>
#include <tuple>

#include "io/images/disocclusion.h"
#include "wavefront/layers/smooth_fill.h"

namespace sturm {

namespace {

bool comes_before(const HiddenPixel& a, const HiddenPixel& b) {
  return std::tie(a.y, a.x) < std::tie(b.y, b.x);
}

}  // namespace

long long add_guessed_background(LayeredPicture& picture, const KernelBank& bank) {
  return add_guessed_background(picture, bank, edges_of(picture));
}

long long add_guessed_background(LayeredPicture& picture, const KernelBank& bank, std::span<const std::size_t> edges) {
  const auto reach = [&](double vergence_D) { return static_cast<double>(bank.radius_at(vergence_D)); };
  const std::vector<HiddenSample> samples =
      extrapolate_hidden(picture.radiance, picture.vergence_D, picture.jump_D, edges, reach);
  std::vector<HiddenPixel> guessed;
  guessed.reserve(samples.size());
  for (const HiddenSample& sample : samples) {
    const HiddenPixel pixel{sample.x, sample.y, sample.vergence_D, 1.0f, {sample.rgb[0], sample.rgb[1], sample.rgb[2]}};
    if (!std::binary_search(picture.hidden.begin(), picture.hidden.end(), pixel, comes_before))
      guessed.push_back(pixel);
  }
  smooth_guesses(picture, guessed);
  std::vector<HiddenPixel> all(picture.hidden.size() + guessed.size());
  std::merge(picture.hidden.begin(), picture.hidden.end(), guessed.begin(), guessed.end(), all.begin(), comes_before);
  picture.hidden = std::move(all);
  return static_cast<long long>(guessed.size());
}

}  // namespace sturm
