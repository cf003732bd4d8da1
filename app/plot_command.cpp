#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/option_values.h"
#include "app/plot_kinds.h"
#include "app/plotted.h"
#include "experiments/figures/blur_curve.h"
#include "experiments/figures/gaze_figures.h"
#include "experiments/figures/lens_maps.h"
#include "experiments/figures/psf_figures.h"
#include "experiments/figures/wavefront_map.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/values.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr std::size_t most_panels = 6, spot_rays = 3000;
constexpr double corridor_limit_D = 0.5;

void require_few(std::size_t panels) {
  if (panels > most_panels)
    throw InputError("", "FILE, --distance", std::to_string(panels) + " panels side by side", "at most 6");
}

std::vector<double> distances(const PlotOptions& options, const std::vector<std::string>& usual) {
  std::vector<double> result;
  for (const std::string& text : options.distances_m.empty() ? usual : options.distances_m)
    result.push_back(distance_option(text, "--distance"));
  return result;
}

/// The one eye of a kind that looks without spectacles.
PlottedEye naked_eye(const PlotOptions& options) {
  const std::vector<PlottedEye> eyes = plotted_eyes(options);
  if (eyes.size() != 1 || eyes[0].worn.spectacles)
    throw InputError("", options.kind, eyes.size() == 1 ? "an eye behind spectacles" : "several eyes",
                     "one eye without spectacles");
  return eyes.front();
}

/// Of rays, in the one light that the eye is in focus at.
PsfSpec psf_spec(const PlottedEye& eye, const PlotOptions& options, const Json& mtf) {
  Json document = {
      {"format", "sturm.psf/1"}, {"eye", eye.eye}, {"models", {"rays"}}, {"distances_m", Json::array()}, {"mtf", mtf}};
  const std::vector<double> targets = distances(options, {"inf", "2", "1", "0.5", "0.33"});
  require_few(targets.size());
  for (const double distance : targets) document["distances_m"].push_back(distance_json(distance));
  return read_psf_spec(document, eye.file);
}

Plot draw_blur(const PlotOptions& options) {
  std::vector<BlurCurve> curves;
  for (const PlottedEye& eye : plotted_eyes(options))
    curves.push_back(blur_curve(eye.worn, eye.name, options.nearest_m, options.clear_D));
  return blur_plot(curves, options.range);
}

Plot draw_spots(const PlotOptions& options) {
  return spot_plot(spot_diagrams(psf_spec(naked_eye(options), options, Json::object()), spot_rays), options.range);
}

Plot draw_mtf(const PlotOptions& options) {
  Json frequencies = Json::array();
  for (int cpd = 0; cpd <= 60; ++cpd) frequencies.push_back(cpd);
  const PlottedEye eye = naked_eye(options);
  PsfSpec spec = psf_spec(eye, options, {{"frequencies_cpd", frequencies}, {"directions_deg", {0, 90}}});
  if (options.psf == "both")
    spec.models.push_back(PsfModel::Waves);
  else
    spec.models = {psf_model_words.value_of(options.psf).value()};
  return mtf_plot(mtf_curves(spec, eye.file));
}

Plot draw_wavefronts(const PlotOptions& options) {
  const std::vector<PlottedEye> eyes = plotted_eyes(options);
  require_few(eyes.size());
  std::vector<LensMap> maps;
  for (const PlottedEye& eye : eyes) maps.push_back(wavefront_map(eye.worn.eye, eye.name));
  return lens_map_plot(maps, {1, options.range});
}

Plot draw_ellipses(const PlotOptions& options) {
  std::vector<EllipseField> fields;
  for (const PlottedEye& eye : plotted_eyes(options))
    for (const double distance : distances(options, {"inf"}))
      fields.push_back(ellipse_field(eye.worn, eye.name, distance, {}, options.clear_D));
  require_few(fields.size());
  return ellipse_field_plot(fields, options.range);
}

/// A row of mean powers above a row of cylinders.
Plot draw_power(const PlotOptions& options) {
  const std::vector<PlottedLens> lenses = plotted_lenses(options);
  const double rotation_center = metres_per_millimetre * options.rotation_center_mm;
  if (options.difference && lenses.size() != 2)
    throw InputError("", "--difference", std::to_string(lenses.size()) + " lenses", "two lenses");
  require_few(lenses.size() + (options.difference ? 1 : 0));
  std::vector<LensMap> mean, cylinder;
  const auto add = [&](const std::vector<LensMap>& pair, const std::string& name) {
    mean.push_back(pair[0]);
    cylinder.push_back(pair[1]);
    for (LensMap* map : {&mean.back(), &cylinder.back()}) map->title = name + "\\n" + map->title;
  };
  for (const PlottedLens& lens : lenses) add(as_worn_maps(lens.lens, lens.nominal, rotation_center), lens.name);
  if (options.difference)
    add(as_worn_difference(lenses[0].lens, lenses[1].lens, rotation_center),
        lenses[1].name + " less " + lenses[0].name);
  mean.insert(mean.end(), cylinder.begin(), cylinder.end());
  return lens_map_plot(mean, {2, options.range});
}

Plot draw_defocus(const PlotOptions& options) {
  const double amplitude_D = amplitude_option(options.worn.age_years, options.worn.amplitude_D);
  std::vector<LensMap> maps;
  const std::vector<double> targets = distances(options, {"0.4"});
  const std::vector<PlottedLens> lenses = plotted_lenses(options);
  require_few(lenses.size());
  for (const double distance : targets)
    for (const PlottedLens& lens : lenses) {
      maps.push_back(defocus_map(lens.lens, lens.nominal.moved_towards_eye(lens.lens.vertex_distance_m),
                                 metres_per_millimetre * options.rotation_center_mm, distance, amplitude_D));
      maps.back().title = lens.name + "\\n" + maps.back().title;
    }
  return lens_map_plot(maps, {targets.size(), options.range});
}

Plot draw_corridor(const PlotOptions& options) {
  std::vector<CorridorProfile> profiles;
  for (const PlottedLens& lens : plotted_lenses(options))
    profiles.push_back(corridor_profile(lens.lens, lens.nominal, metres_per_millimetre * options.rotation_center_mm,
                                        lens.name, corridor_limit_D));
  return corridor_plot(profiles);
}

Plot draw(const PlotOptions& options) {
  switch (plot_kind_words.value_of(options.kind).value()) {
    case PlotKind::Blur:
      return draw_blur(options);
    case PlotKind::Spots:
      return draw_spots(options);
    case PlotKind::Wavefront:
      return draw_wavefronts(options);
    case PlotKind::Mtf:
      return draw_mtf(options);
    case PlotKind::Ellipses:
      return draw_ellipses(options);
    case PlotKind::Power:
      return draw_power(options);
    case PlotKind::Defocus:
      return draw_defocus(options);
    case PlotKind::Corridor:
      return draw_corridor(options);
  }
  throw std::logic_error("a kind of plot without a picture");
}

}  // namespace

int plot_command(const PlotOptions& options) {
  if (!is_picture_name(options.output))
    throw InputError("", "--output", "\"" + options.output + "\"", "a file name that ends in .svg, .png or .pdf");
  std::filesystem::path csv = options.csv;
  if (csv.empty()) csv = std::filesystem::path(options.output).replace_extension(".csv");
  require_writable(options.output);
  require_writable(csv);
  const Plot plot = draw(options);
  const std::string picture = plot_file(plot, options.output);
  write_file_atomically(options.output, picture);
  write_file_atomically(csv, plot.csv);
  return 0;
}

}  // namespace sturm
