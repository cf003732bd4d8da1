#include "pathtrace/scene/environment_picture.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/images/picture_file.h"

namespace sturm {

namespace {

constexpr std::size_t most_pixels = std::size_t{1} << 25;  // 8192 × 4096

/// Pixels that a clamp has changed.
struct Clamped {
  std::size_t below = 0, above = 0;
};

/// Moves values into 0 … `most`; a NaN stays.
Clamped clamp_values(Image& picture, float most) {
  Clamped count;
  for (std::size_t i = 0; i < picture.pixels.size(); i += static_cast<std::size_t>(picture.channels)) {
    bool below = false, above = false;
    for (std::size_t c = 0; c < static_cast<std::size_t>(picture.channels); ++c) {
      float& value = picture.pixels[i + c];
      below = below || value < 0.0f;
      above = above || value > most;
      if (value < 0.0f || value > most) value = value < 0.0f ? 0.0f : most;
    }
    count.below += below;
    count.above += above;
  }
  return count;
}

std::string pixels_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " pixel" : " pixels");
}

}  // namespace

std::shared_ptr<const Image> read_environment_picture(const EnvironmentSpec& environment,
                                                      std::vector<std::string>& notes) {
  const std::filesystem::path& file = environment.file.value();
  const auto note = [&](const std::string& text) { notes.push_back(file.filename().string() + ": " + text); };
  PictureFile read = read_picture_file(file, environment.layer);
  if (read.values == PixelValues::Linear || environment.encoding == TextureEncoding::Srgb) make_linear(read);
  auto picture = std::make_shared<Image>(without_alpha(read.image()));
  for (const std::string& text : read.notes) note(text);
  if (picture->pixels.size() / 3 > most_pixels)
    throw InputError(file.string(), "",
                     std::to_string(picture->width) + " x " + std::to_string(picture->height) + " pixels",
                     "at most 2^25 pixels (8192 x 4096)");
  if (environment.clamp) {
    const auto most = static_cast<float>(*environment.clamp);
    const Clamped count = clamp_values(*picture, most);
    if (count.below > 0) note(pixels_text(count.below) + " with values below 0 clamped to 0");
    if (count.above > 0) note(pixels_text(count.above) + " with values above " + exact_number(most) + " clamped to it");
  }
  require_light(*picture, file.string(),
                environment.clamp ? "" : ", or \"clamp\" in the environment for negative and infinite ones");
  return picture;
}

}  // namespace sturm
