#include "app/see_inputs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/distance_option.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/images/exr.h"
#include "io/images/image_formats.h"
#include "io/images/tone_map.h"
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

/// The layer that holds a picture: the main one, one that a renderer calls Combined, or the only one in colour; last, a
/// main layer of luminance.
const Image& color_layer(const LayeredImage& file, const std::string& path) {
  if (const auto main = file.layers.find(""); main != file.layers.end() && main->second.channels >= 3)
    return main->second;
  const Image* only = nullptr;
  int colored = 0;
  for (const auto& [name, layer] : file.layers) {
    if (layer.channels < 3 || name == "normal" || name.ends_with(".normal")) continue;
    if (name.ends_with("Combined")) return layer;
    only = &layer;
    ++colored;
  }
  if (colored == 1) return *only;
  for (const char* luminance : {"", "Y"})
    if (const auto layer = file.layers.find(luminance); layer != file.layers.end() && layer->second.channels == 1)
      return layer->second;
  throw InputError(path, "", "no channels R, G, B", "a picture");
}

/// Splits 1 … 4 channels into colours and coverage. Colours of EXR files are multiplied by the coverage, as the format
/// has it, unless there are colours where the coverage is 0.
void split_channels(const Image& image, bool may_be_multiplied, ColorFile& file) {
  const int channels = image.channels;
  const bool alpha = channels == 2 || channels == 4, gray = channels < 3;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * image.height;
  file.radiance = Image(image.width, image.height, 3);
  bool multiplied = alpha && may_be_multiplied, partial = false;
  for (std::size_t i = 0; i < pixels && alpha; ++i) {
    const float* p = &image.pixels[i * channels];
    partial = partial || p[channels - 1] < 1.0f;
    if (p[channels - 1] <= 0.0f && std::max({p[0], p[gray ? 0 : 1], p[gray ? 0 : 2]}) > 0.0f) multiplied = false;
  }
  if (partial) file.coverage.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* p = &image.pixels[i * channels];
    const float a = partial ? std::clamp(p[channels - 1], 0.0f, 1.0f) : 1.0f;
    if (partial) file.coverage[i] = a;
    for (int c = 0; c < 3; ++c) file.radiance.pixels[3 * i + c] = p[gray ? 0 : c] / (multiplied && a > 0.0f ? a : 1.0f);
  }
}

/// Light is finite. What little lies below zero, as filters of renderers leave it, counts as dark.
void require_light(Image& radiance, const std::string& path, std::vector<std::string>& notes) {
  long long below = 0;
  for (std::size_t i = 0; i < radiance.pixels.size(); ++i) {
    float& value = radiance.pixels[i];
    if (!std::isfinite(value))
      throw InputError(path, "",
                       "a value that is not finite at column " + std::to_string(i / 3 % radiance.width) + ", row " +
                           std::to_string(i / 3 / radiance.width),
                       "a picture of finite numbers");
    below += value < 0.0f;
    value = std::max(0.0f, value);
  }
  if (below > 0) notes.push_back(path + ": " + std::to_string(below) + " negative values were taken for 0");
}

ColorFile read_color_file(const std::string& path, std::vector<std::string>& notes) {
  ColorFile file;
  if (has_suffix(path, ".exr")) {
    const LayeredImage layers = read_exr(path);
    split_channels(color_layer(layers, path), true, file);
    if (const Image* depth = depth_layer(layers)) file.depth = *depth;
    file.pixel_slope = view_of(layers).pixel_slope;
  } else {
    const Image encoded = read_image(path);
    if (encoded.channels > 4) throw InputError(path, "", std::to_string(encoded.channels) + " channels", "a picture");
    split_channels(srgb_to_linear(encoded), false, file);
  }
  require_light(file.radiance, path, notes);
  return file;
}

DepthReading depth_reading(const SeeOptions& options) {
  DepthReading reading;
  reading.scale = options.depth_scale;
  if (options.disparity) {
    if (!options.depth_unit.empty())
      throw InputError("", "--depth-unit", "\"" + options.depth_unit + "\"", "no unit beside --disparity");
    if (!options.focal_px || !options.baseline_m)
      throw InputError("", "--disparity", "no calibration", "--focal-px and --baseline-m");
    reading.unit = DepthUnit::Disparity;
    reading.stereo = {*options.focal_px, *options.baseline_m, options.doffs_px};
  } else if (options.depth_unit == "m") {
    reading.unit = DepthUnit::Metres;
  } else if (options.depth_unit == "mm") {
    reading.unit = DepthUnit::Millimetres;
  } else if (options.depth_unit == "D") {
    reading.unit = DepthUnit::Dioptres;
  }
  return reading;
}

std::string size_of(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

void require_size(int width, int height, const Image& picture, const std::string& file) {
  if (width != picture.width || height != picture.height)
    throw InputError(file, "", size_of(width, height), size_of(picture.width, picture.height) + " as the picture has");
}

/// The picture's vergences, from where the options say.
DepthMap picture_depth(const SeeOptions& options, const ColorFile& file, SeeInputs& inputs) {
  const std::string map = !options.disparity_file.empty() ? options.disparity_file : options.depth;
  if (!options.distance_m.empty()) {
    if (!map.empty()) throw InputError("", "--distance-m", options.distance_m, "either a distance or a depth map");
    const double vergence = 1.0 / distance_option(options.distance_m, "--distance-m");
    return {file.radiance.width, file.radiance.height, std::vector<double>(file.radiance.pixels.size() / 3, vergence),
            0};
  }
  if (!map.empty()) {
    inputs.files.push_back(map);
    return read_depth_map(map, depth_reading(options));
  }
  if (file.depth) return depth_of(*file.depth, depth_reading(options), options.picture + ", its depth channel");
  throw InputError(options.picture, "", "no depth", "--depth FILE, a picture with a channel Z, or --distance-m");
}

void add_layer(const std::string& path, const SeeOptions& options, SeeInputs& inputs) {
  ColorFile file = read_color_file(path, inputs.notes);
  inputs.files.push_back(path);
  require_size(file.radiance.width, file.radiance.height, inputs.picture.radiance, path);
  if (!file.depth) throw InputError(path, "", "no channel Z", "a layer with its own depth");
  DepthMap depth = depth_of(*file.depth, depth_reading(options), path + ", its depth channel");
  inputs.filled_holes += depth.filled_holes;
  inputs.layers.push_back({std::move(file.radiance), std::move(depth.vergence_D), std::move(file.coverage)});
}

double pixel_slope_of(const SeeOptions& options, const ColorFile& file) {
  const auto of_angle = [](double degrees, int pixels) {
    return 2.0 * std::tan(0.5 * degrees * radians_per_degree) / pixels;
  };
  if (options.vfov_deg) return of_angle(*options.vfov_deg, file.radiance.height);
  if (options.hfov_deg) return of_angle(*options.hfov_deg, file.radiance.width);
  if (file.pixel_slope) return *file.pixel_slope;
  throw InputError(options.picture, "", "no field of view", "--vfov-deg or --hfov-deg");
}

}  // namespace

SeeInputs read_see_inputs(const SeeOptions& options) {
  SeeInputs inputs;
  ColorFile file = read_color_file(options.picture, inputs.notes);
  inputs.files.push_back(options.picture);
  inputs.pixel_slope = pixel_slope_of(options, file);
  DepthMap depth = picture_depth(options, file, inputs);
  require_size(depth.width, depth.height, file.radiance, inputs.files.back());
  inputs.filled_holes = depth.filled_holes;
  inputs.picture.radiance = std::move(file.radiance);
  inputs.picture.coverage = std::move(file.coverage);
  inputs.picture.vergence_D = std::move(depth.vergence_D);
  for (const std::string& layer : options.layers) add_layer(layer, options, inputs);
  if (inputs.filled_holes > 0)
    inputs.notes.push_back(std::to_string(inputs.filled_holes) +
                           " pixels without depth got that of their farthest neighbour");
  return inputs;
}

}  // namespace sturm
