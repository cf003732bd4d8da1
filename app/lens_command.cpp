#include <charconv>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/option_values.h"
#include "experiments/figures/lens_maps.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/spectacles_spec.h"
#include "lensmodel/units.h"
#include "lensmodel/vertex_power.h"
#include "stages/lens_stage.h"

namespace sturm {

namespace {

constexpr double largest_angle_deg = 89.0;
constexpr double most_angles = 721.0;

/// FIRST:LAST:STEP or one angle.
std::vector<double> angles(const std::string& text, const char* option) {
  const auto refuse = [&] {
    throw InputError(
        "", option, "\"" + text + "\"",
        "FIRST:LAST:STEP with -89 <= FIRST <= LAST <= 89, STEP > 0 and at most 721 angles, or one angle [deg]");
  };
  std::vector<double> numbers;
  const char *at = text.data(), *end = at + text.size();
  for (double number = 0.0;; ++at) {
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc()) refuse();
    numbers.push_back(number);
    at = stop;
    if (at == end) break;
    if (*at != ':') refuse();
  }
  if (numbers.size() == 1) numbers = {numbers[0], numbers[0], 1.0};
  if (numbers.size() != 3) refuse();
  const double first = numbers[0], last = numbers[1], step = numbers[2];
  if (!(first >= -largest_angle_deg && first <= last && last <= largest_angle_deg && step > 0.0)) refuse();
  const double steps = std::floor((last - first) / step * (1.0 + 1e-12));  // 0:1:0.1 reaches 1
  if (!(steps < most_angles)) refuse();
  std::vector<double> result;
  for (int i = 0; i <= static_cast<int>(steps); ++i) result.push_back(std::fmin(first + i * step, last));
  return result;
}

SpectaclesSpec read_lens(const Json& document, const std::string& file) {
  if (format_of(document, file) != "spectacles")
    Source{file, "/format"}.fail(document.at("format"), "\"sturm.spectacles/1\"");
  validate(document, "spectacles", file);
  return read_lens_alone(document, {file, ""});
}

/// The lens with what the options change; a single-vision lens where no file was given.
Json lens_document(const CommonOptions& options, const LensOptions& lens) {
  Json document = load_configuration(
      options,
      {{"format", "sturm.spectacles/1"}, {"single_vision", {{"center_thickness_mm", 2}, {"refractive_index", 1.5}}}});
  for (const auto& [key, value] :
       {std::pair("refractive_index", lens.refractive_index),
        std::pair("center_thickness_mm", lens.center_thickness_mm), std::pair("diameter_mm", lens.diameter_mm)}) {
    if (!value || !document.is_object()) continue;
    Json* made = &document;
    for (const char* maker : {"single_vision", "progressive", "lens_file"})
      if (document.contains(maker)) made = &document[maker];
    if (made->is_object()) (*made)[key] = *value;
    if (made->is_object() && std::string_view(key) == "refractive_index") made->erase("material");
  }
  return document;
}

/// Throws where a picture could not be written as named.
void check_picture_name(const std::string& name, const char* option) {
  if (!name.empty() && !is_picture_name(name))
    throw InputError("", option, "\"" + name + "\"", "a file name that ends in .svg, .png or .pdf");
}

std::vector<double> distances(const std::vector<std::string>& texts) {
  std::vector<double> result;
  for (const std::string& text : texts) result.push_back(distance_option(text, "--distance"));
  return result;
}

void write_picture(const std::string& name, const std::vector<LensMap>& maps) {
  write_file_atomically(name, plot_file(lens_map_plot(maps), name));
}

}  // namespace

int lens_command(const CommonOptions& given, const LensOptions& lens, const std::string& output) {
  const CommonOptions options = with_source(given);
  const Json document = lens_document(options, lens);
  if (options.print_config) return print_configuration(document, options.file, output);
  LensQuery query;
  query.azimuths_deg = angles(lens.azimuths_deg, "--azimuth-deg");
  query.elevations_deg = angles(lens.elevations_deg, "--elevation-deg");
  query.rotation_center_m = metres_per_millimetre * lens.rotation_center_mm;
  check_picture_name(lens.map_file, "--map");
  check_picture_name(lens.defocus_map_file, "--defocus-map");
  const std::vector<double> targets = distances(lens.target_distances_m);
  const SpectaclesSpec spec = read_lens(document, options.file);
  for (const std::string& note : spec.notes) std::cerr << "note: " << note << "\n";
  query.lens = spec.lens.value();
  query.material = spec.material;
  query.fits = spec.fits;
  if (!lens.map_file.empty())
    write_picture(lens.map_file,
                  as_worn_maps(query.lens, nominal_power(spec, {options.file, ""}), query.rotation_center_m));
  if (!lens.defocus_map_file.empty()) {
    const PowerMatrix correction =
        nominal_power(spec, {options.file, ""}).moved_towards_eye(query.lens.vertex_distance_m);
    std::vector<LensMap> maps;
    for (const double distance : targets)
      maps.push_back(defocus_map(query.lens, correction, query.rotation_center_m, distance, lens.amplitude_D));
    write_picture(lens.defocus_map_file, maps);
  }
  write_result(lens_report(query), output);
  return 0;
}

}  // namespace sturm
