#include "app/see_inputs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/images/picture_file.h"
#include "lensmodel/units.h"
#include "stages/picture_view.h"

namespace sturm {

namespace {

/// A picture as its file has it: linear colours that are not multiplied by the coverage.
struct ColorFile {
  Image radiance;
  std::vector<float> coverage;  // empty: covers all
  std::optional<Image> depth;
  std::optional<double> pixel_slope;
};

void require_finite_coverage(const Image& image, const std::string& path) {
  if (image.channels < 4) return;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (const float a = image.at(x, y)[3]; !std::isfinite(a))
        throw InputError(path, formatted("pixel (%d, %d)", x, y), formatted("%g in A", a), "a finite coverage");
}

/// Splits 3 or 4 channels into colours and coverage. Colours of EXR files are multiplied by the coverage, as the format
/// has it, unless there are colours where the coverage is 0.
void split_channels(const Image& image, bool may_be_multiplied, ColorFile& file) {
  file.radiance = without_alpha(image);
  if (image.channels < 4) return;
  const std::size_t pixels = file.radiance.pixels.size() / 3;
  bool multiplied = may_be_multiplied, partial = false;
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* p = &image.pixels[4 * i];
    partial = partial || p[3] < 1.0f;
    if (p[3] <= 0.0f && std::max({p[0], p[1], p[2]}) > 0.0f) multiplied = false;
  }
  if (!partial) return;
  file.coverage.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const float a = file.coverage[i] = std::clamp(image.pixels[4 * i + 3], 0.0f, 1.0f);
    for (int c = 0; c < 3 && multiplied && a > 0.0f; ++c) file.radiance.pixels[3 * i + c] /= a;
  }
}

/// What little lies below zero, as filters of renderers leave it, counts as dark.
void darken_negative(Image& radiance, const std::string& path, std::vector<std::string>& notes) {
  long long below = 0;
  for (float& value : radiance.pixels) {
    below += value < 0.0f;
    value = std::max(0.0f, value);
  }
  if (below > 0) notes.push_back(path + ": " + std::to_string(below) + " negative values were taken for 0");
}

/// What a picture does not cover is black where no layer tells what lies behind it.
void put_before_black(ColorFile& file, const std::string& path, std::vector<std::string>& notes) {
  if (file.coverage.empty()) return;
  for (std::size_t i = 0; i < file.coverage.size(); ++i)
    for (int c = 0; c < 3; ++c) file.radiance.pixels[3 * i + c] *= file.coverage[i];
  const auto transparent = std::count_if(file.coverage.begin(), file.coverage.end(), [](float a) { return a < 1.0f; });
  notes.push_back(path + ": " + std::to_string(transparent) +
                  " pixels are transparent, and what lies behind them is taken for black, as no --layer tells it");
  file.coverage.clear();
}

ColorFile read_color_file(const std::string& path, const SeeSpec& spec, std::vector<std::string>& notes) {
  const bool layered = has_layers(path);
  PictureFile picture = read_picture_file(path, layered ? spec.picture_layer : std::nullopt);
  require_finite_pixels(picture.image(), path);
  require_finite_coverage(picture.image(), path);
  ColorFile file;
  make_linear(picture);
  split_channels(picture.image(), layered, file);
  for (const std::string& note : picture.notes) notes.push_back(path + ": " + note);
  darken_negative(file.radiance, path, notes);
  file.pixel_slope = view_of(picture.picture).pixel_slope;
  if (const auto depth = picture.picture.layers.find("depth"); depth != picture.picture.layers.end())
    file.depth = std::move(depth->second);
  return file;
}

std::string size_of(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

void require_size(int width, int height, const Image& picture, const std::string& file) {
  if (width != picture.width || height != picture.height)
    throw InputError(file, "", size_of(width, height), size_of(picture.width, picture.height) + " as the picture has");
}

/// The picture's vergences, from where the document says.
DepthMap picture_depth(const SeeSpec& spec, const ColorFile& file) {
  if (spec.distance_m)
    return {file.radiance.width, file.radiance.height,
            std::vector<double>(file.radiance.pixels.size() / 3, 1.0 / *spec.distance_m), 0};
  if (spec.depth_map) return read_depth_map(*spec.depth_map, spec.depth_reading);
  if (file.depth) return depth_of(*file.depth, spec.depth_reading, spec.picture + ", its depth channel");
  throw InputError(spec.picture, "", "no depth", "--depth FILE, a picture with a channel Z, or --distance-m");
}

void add_layer(const std::string& path, const SeeSpec& spec, SeeInputs& inputs) {
  ColorFile file = read_color_file(path, spec, inputs.notes);
  require_size(file.radiance.width, file.radiance.height, inputs.picture.radiance, path);
  if (!file.depth) throw InputError(path, "", "no channel Z", "a layer with its own depth");
  DepthMap depth = depth_of(*file.depth, spec.depth_reading, path + ", its depth channel");
  inputs.filled_holes += depth.filled_holes;
  inputs.layers.push_back({std::move(file.radiance), std::move(depth.vergence_D), std::move(file.coverage)});
}

double pixel_slope_of(const SeeSpec& spec, const ColorFile& file) {
  const auto of_angle = [](double degrees, int pixels) {
    return 2.0 * std::tan(0.5 * degrees * radians_per_degree) / pixels;
  };
  if (spec.vfov_deg) return of_angle(*spec.vfov_deg, file.radiance.height);
  if (spec.hfov_deg) return of_angle(*spec.hfov_deg, file.radiance.width);
  if (spec.pixel_slope) return *spec.pixel_slope;
  if (file.pixel_slope) return *file.pixel_slope;
  throw InputError(spec.picture, "", "no field of view", "--vfov-deg or --hfov-deg");
}

}  // namespace

SeeInputs read_see_inputs(const SeeSpec& spec) {
  SeeInputs inputs;
  ColorFile file = read_color_file(spec.picture, spec, inputs.notes);
  if (spec.layers.empty()) put_before_black(file, spec.picture, inputs.notes);
  inputs.pixel_slope = pixel_slope_of(spec, file);
  DepthMap depth = picture_depth(spec, file);
  require_size(depth.width, depth.height, file.radiance, spec.depth_map.value_or(spec.picture));
  inputs.filled_holes = depth.filled_holes;
  inputs.picture.radiance = std::move(file.radiance);
  inputs.picture.coverage = std::move(file.coverage);
  inputs.picture.vergence_D = std::move(depth.vergence_D);
  for (const std::string& layer : spec.layers) add_layer(layer, spec, inputs);
  if (inputs.filled_holes > 0)
    inputs.notes.push_back(std::to_string(inputs.filled_holes) +
                           " pixels without depth got that of their farthest neighbour");
  return inputs;
}

}  // namespace sturm
