#include <charconv>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/lens_table.h"
#include "app/option_values.h"
#include "app/plotted.h"
#include "app/several_documents.h"
#include "experiments/figures/lens_maps.h"
#include "experiments/figures/lens_plots.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/spectacles_spec.h"
#include "lensmodel/units.h"
#include "stages/lens_stage.h"

namespace sturm {

namespace {

constexpr double largest_angle_deg = 89.0;
constexpr double most_angles = 721.0, usual_clear_D = 0.25;

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
  Json document = load_configuration(options, usual_lens());
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

/// A lens as the options have it, and what is asked of it.
struct AskedLens {
  std::string file;
  SpectaclesSpec spec;
  LensQuery query;
  NamedLens plotted;  ///< without a nominal power where no picture needs one
};

bool has_pictures(const LensOptions& lens) {
  return !(lens.map_file.empty() && lens.defocus_map_file.empty() && lens.corridor_file.empty() &&
           lens.ellipses_file.empty());
}

AskedLens asked_lens(const Json& document, const std::string& file, const std::string& name, const LensOptions& lens) {
  AskedLens asked{file, read_lens(document, file), {}, {}};
  for (const std::string& note : asked.spec.notes) std::cerr << "note: " << note << "\n";
  asked.query = {.lens = asked.spec.lens.value(),
                 .material = asked.spec.material,
                 .fits = asked.spec.fits,
                 .rotation_center_m = metres_per_millimetre * lens.rotation_center_mm,
                 .azimuths_deg = angles(lens.azimuths_deg, "--azimuth-deg"),
                 .elevations_deg = angles(lens.elevations_deg, "--elevation-deg")};
  asked.plotted = {name, asked.query.lens, has_pictures(lens) ? nominal_power(asked.spec, {file, ""}) : PowerMatrix()};
  return asked;
}

/// Throws where a picture could not be written as named.
void check_pictures(const LensOptions& lens) {
  for (const auto& [name, option] :
       {std::pair(lens.map_file, "--map"), std::pair(lens.defocus_map_file, "--defocus-map"),
        std::pair(lens.corridor_file, "--corridor"), std::pair(lens.ellipses_file, "--ellipses")}) {
    if (name.empty()) continue;
    if (!is_picture_name(name))
      throw InputError("", option, "\"" + name + "\"", "a file name that ends in .svg, .png or .pdf");
    require_writable(name);
  }
}

std::vector<double> distances(const LensOptions& lens) {
  std::vector<double> result;
  for (const std::string& text : lens.distances_m) result.push_back(distance_option(text, "--distance"));
  return result;
}

Plot maps_of(const std::vector<NamedLens>& lenses, double rotation_center_m, std::optional<double> range) {
  if (lenses.size() > 1) return power_plot(lenses, rotation_center_m, true, range);
  return lens_map_plot(as_worn_maps(lenses[0].lens, lenses[0].nominal, rotation_center_m), {1, range});
}

/// The pictures that are asked for, by the names of their files.
std::vector<std::pair<std::string, std::string>> drawn_pictures(const std::vector<AskedLens>& asked,
                                                                const LensOptions& lens) {
  const std::vector<double> targets = distances(lens);
  const double rotation_center_m = metres_per_millimetre * lens.rotation_center_mm;
  std::vector<NamedLens> lenses;
  std::vector<NamedEye> eyes;
  for (const AskedLens& one : asked) {
    lenses.push_back(one.plotted);
    if (!lens.ellipses_file.empty())
      eyes.push_back({one.plotted.name, eye_behind(one.plotted, one.file, lens.eye).worn});
  }
  std::vector<std::pair<std::string, std::string>> pictures;
  const auto draw = [&](const std::string& name, std::size_t panels, const auto& plot) {
    if (name.empty()) return;
    require_few_panels(panels);
    pictures.emplace_back(name, plot_file(plot(), name));
  };
  draw(lens.map_file, 2 * lenses.size() - 1, [&] { return maps_of(lenses, rotation_center_m, lens.range); });
  draw(lens.defocus_map_file, lenses.size(), [&] {
    const double amplitude_D = amplitude_option(lens.eye.age_years, lens.eye.amplitude_D);
    return defocus_plot(lenses, rotation_center_m, targets, amplitude_D, lens.range);
  });
  draw(lens.corridor_file, 1, [&] { return corridor_plot(corridor_profiles(lenses, rotation_center_m)); });
  draw(lens.ellipses_file, eyes.size() * targets.size(),
       [&] { return fields_plot(eyes, targets, usual_clear_D, std::nullopt); });
  return pictures;
}

}  // namespace

int lens_command(const CommonOptions& given, const LensOptions& lens, const std::string& output) {
  if (given.print_config) {
    const CommonOptions options = with_source(with_one_document(given, "--print-config"));
    return print_configuration(lens_document(options, lens), options.file, output);
  }
  const AnswerKind kind = answer_kind(lens.answer, output, given.files.size());
  check_pictures(lens);
  const std::vector<std::string> files = files_of(given);
  const std::vector<std::string> names = given.files.empty() ? std::vector{given.prescription} : document_names(files);
  std::vector<AskedLens> asked;
  for (std::size_t i = 0; i < files.size(); ++i)
    asked.push_back(asked_lens(lens_document(with_file(given, files[i]), lens), files[i], names[i], lens));
  std::vector<std::string> outputs;
  if (kind == AnswerKind::Json) outputs = outputs_of(files, output, ".json", "--output");
  const auto pictures = drawn_pictures(asked, lens);
  std::vector<NamedLensReport> reports;
  for (std::size_t i = 0; i < files.size(); ++i) reports.push_back({names[i], lens_report(asked[i].query)});
  for (const auto& [name, picture] : pictures) write_file_atomically(name, picture);
  if (kind == AnswerKind::Csv)
    write_text(lens_csv(reports), output);
  else if (kind == AnswerKind::Table)
    write_text(lens_table(reports), output);
  else
    for (std::size_t i = 0; i < files.size(); ++i) write_result(reports[i].report, outputs[i]);
  return 0;
}

}  // namespace sturm
