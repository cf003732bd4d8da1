#include "stages/psf_pictures.h"

#include <algorithm>

#include "io/files/formatted_text.h"

namespace sturm {

namespace {

Image picture_of(const PsfCells& cells) {
  const auto side = static_cast<int>(cells.energy.rows());
  Image image(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)  // the frame's y points up; rounding leaves zeros a little negative
      *image.at(x, y) = static_cast<float>(std::max(0.0, cells.energy(side - 1 - y, x)));
  return image;
}

}  // namespace

std::vector<ExrPart> psf_parts(const PsfSpec& spec, const PointSpreads& spreads) {
  std::vector<ExrPart> parts;
  for (const MeasuredSpread& spread : spreads.spreads) {
    const PsfTarget& target = spec.targets[spread.target];
    const std::string model(psf_model_words.word_of(spread.model)), light = spec.lights[spread.light].id;
    parts.push_back({formatted("%s.%s.%zu", model.c_str(), light.c_str(), spread.target),
                     {"Y"},
                     picture_of(spread.picture),
                     {{"sturm.model", model},
                      {"sturm.light", light},
                      {"sturm.defocus_D", plain_number(target.vergence_D)},
                      {"sturm.pixel_arcmin", plain_number(spec.pixel_arcmin)}}});
  }
  return parts;
}

Image psf_sheet(const PsfSpec& spec, const PointSpreads& spreads) {
  constexpr int gap = 2;
  const int side = spec.size_px, tile = side + gap;
  const auto columns = static_cast<int>(spec.targets.size()),
             rows = static_cast<int>(spec.lights.size() * spec.models.size());
  Image sheet(columns * tile - gap, rows * tile - gap, 1);
  std::fill(sheet.pixels.begin(), sheet.pixels.end(), 1.0f);
  for (std::size_t i = 0; i < spreads.spreads.size(); ++i) {
    const MeasuredSpread& spread = spreads.spreads[i];
    Image picture = picture_of(spread.picture);
    const float largest = *std::max_element(picture.pixels.begin(), picture.pixels.end());
    const int left = static_cast<int>(spread.target) * tile,
              top = static_cast<int>(spread.light * spec.models.size() + i % spec.models.size()) * tile;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) *sheet.at(left + x, top + y) = largest > 0.0f ? *picture.at(x, y) / largest : 0.0f;
  }
  return sheet;
}

}  // namespace sturm
