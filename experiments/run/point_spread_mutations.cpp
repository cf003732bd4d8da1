#include "experiments/run/point_spread_mutations.h"

#include "io/images/tone_map.h"
#include "stages/prediction_stage.h"

namespace sturm {

namespace {

template <class Change>
void change_colours(LayeredPicture& picture, const Change& change) {
  for (float& value : picture.radiance.pixels) value = change(value);
  for (HiddenPixel& pixel : picture.hidden)
    for (float& value : pixel.rgb) value = change(value);
}

std::vector<Image> seen_by(const Eye& eye, const PointSpreadPictures& honest) {
  std::vector<Image> pictures;
  for (SurfacesPicture surfaces : honest.surfaces)
    pictures.push_back(see_through_point_spreads(surfaces, eye, honest.pixel_slope, honest.prediction).radiance);
  return pictures;
}

std::vector<Image> blurred_as_encoded(const PointSpreadPictures& honest) {
  std::vector<Image> pictures;
  for (SurfacesPicture surfaces : honest.surfaces) {
    change_colours(surfaces.picture, [](float v) { return linear_to_srgb(v); });
    Image& picture = pictures.emplace_back(
        see_through_point_spreads(surfaces, honest.eye, honest.pixel_slope, honest.prediction).radiance);
    for (float& value : picture.pixels) value = srgb_to_linear(value);
  }
  return pictures;
}

template <class Change>
std::vector<Image> changed(const std::vector<Image>& pictures, const Change& change) {
  std::vector<Image> result;
  for (const Image& picture : pictures) result.push_back(change(picture));
  return result;
}

}  // namespace

std::optional<std::vector<Image>> mutated_point_spreads(const Mutation& mutation, const PointSpreadPictures& honest) {
  if (const auto* wrong = std::get_if<mutation::WrongEye>(&mutation.kind))
    return seen_by(wrong->read(honest.eye), honest);
  if (std::holds_alternative<mutation::BlurredAsEncoded>(mutation.kind)) return blurred_as_encoded(honest);
  if (std::holds_alternative<mutation::HalfPixelShift>(mutation.kind))
    return changed(honest.predictions, moved_half_pixel);
  if (const auto* lost = std::get_if<mutation::LostLight>(&mutation.kind))
    return changed(honest.predictions, [&](Image image) { return with_less_light(std::move(image), *lost); });
  return std::nullopt;
}

}  // namespace sturm
