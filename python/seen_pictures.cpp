#include <pybind11/stl.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/images/depth_map.h"
#include "io/images/picture_file.h"
#include "io/specs/eye_spec.h"
#include "lensmodel/units.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/eye_objects.h"
#include "python/watched_work.h"
#include "stages/see_stage.h"

namespace sturm {

namespace {

constexpr int colours = 3;

Image light_of(const py::object& picture, const char* name) {
  Image light = image_of(picture, name, colours);
  if (light.channels != colours)
    throw InputError("", name, std::to_string(light.channels) + " channels", "height × width × 3");
  require_light(light, name);
  return light;
}

/// Vergences [D] of an array of distances [m], or of one distance for all pixels.
std::vector<double> vergences_of(const py::object& depth_m, const Image& picture, const char* name) {
  const std::size_t pixels = picture.pixels.size() / colours;
  if (PyFloat_Check(depth_m.ptr()) || PyLong_Check(depth_m.ptr())) {
    const double distance_m = depth_m.cast<double>();
    if (!(distance_m > 0.0)) throw InputError("", name, exact_number(distance_m), "a distance > 0 [m], or infinity");
    return std::vector<double>(pixels, vergence_of(distance_m));
  }
  const Image depth = image_of(depth_m, name, 1);
  if (depth.width != picture.width || depth.height != picture.height)
    throw InputError(
        "", name, std::to_string(depth.width) + " × " + std::to_string(depth.height) + " pixels",
        "the size of the picture, " + std::to_string(picture.width) + " × " + std::to_string(picture.height));
  return depth_of(depth, {DepthUnit::Metres, std::nullopt, {}}, name).vergence_D;
}

/// One gaze and one accommodation hold for the whole picture, so that an eye which chooses needs one distance.
double accommodation_of(const Eye& eye, const std::vector<double>& vergences_D, bool flat) {
  if (!flat) require_camera_accommodation(eye.accommodation, std::nullopt, {"", "eye"});
  return eye.accommodation_for(vergences_D.front());
}

SeeSettings settings_of(const EyeObject& wearer, const std::string& psf, bool chromatic, int parts) {
  const auto kind = seen_psf_words.value_of(psf);
  if (!kind) throw InputError("", "psf", "\"" + psf + "\"", "\"rays\" or \"waves\"");
  if (parts < 1) throw InputError("", "parts", std::to_string(parts), "a whole number of at least 1");
  SeeSettings settings;
  settings.eye = wearer.eye;
  settings.psf = *kind;
  settings.chromatic = chromatic;
  settings.parts = parts;
  return settings;
}

py::tuple seen(const py::object& radiance, const py::object& depth_m, const EyeObject& wearer, double vfov_deg,
               const py::list& hidden, const std::string& psf, bool chromatic, int parts, const py::object& progress) {
  SeeSettings settings = settings_of(wearer, psf, chromatic, parts);
  LayeredPicture picture;
  picture.radiance = light_of(radiance, "picture");
  picture.vergence_D = vergences_of(depth_m, picture.radiance, "depth_m");
  const bool flat = !py::hasattr(depth_m, "shape");
  settings.accommodation_D = accommodation_of(wearer.eye, picture.vergence_D, flat);
  if (!(vfov_deg > 0.0 && vfov_deg < 180.0))
    throw InputError("", "vfov_deg", exact_number(vfov_deg), "an angle between 0 and 180 [deg]");
  settings.pixel_slope = 2.0 * std::tan(0.5 * vfov_deg * radians_per_degree) / picture.radiance.height;
  std::vector<PictureLayer> layers;
  for (const py::handle layer : hidden) {
    const auto [layer_radiance, layer_depth_m] = layer.cast<std::pair<py::object, py::object>>();
    Image light = light_of(layer_radiance, "layers");
    std::vector<double> vergences_D = vergences_of(layer_depth_m, light, "layers");
    layers.push_back({std::move(light), std::move(vergences_D), {}});
  }
  SeenPicture result;
  do_watched(progress, [&](const std::function<void(double)>& report) {
    settings.progress = report;
    result = see_picture(picture, layers, settings);
  });
  return py::make_tuple(array_of(std::move(result.radiance)), result.planes_D, result.hidden_given,
                        result.hidden_guessed, result.seconds);
}

}  // namespace

void bind_seen_pictures(py::module_& module) {
  using namespace pybind11::literals;
  module.attr("usual_parts") = usual_parts;
  module.def(
      "see_picture", &seen, "picture"_a, "depth_m"_a, "eye"_a, "vfov_deg"_a, "layers"_a, "psf"_a, "chromatic"_a,
      "parts"_a, "progress"_a,
      "What an eye sees of a picture with depth: light, vergences of the planes [D], pixels of hidden surfaces that\n"
      "were given and guessed, and seconds.");
}

}  // namespace sturm
