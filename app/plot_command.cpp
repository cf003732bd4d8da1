#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/option_values.h"
#include "app/plot_kinds.h"
#include "app/plotted.h"
#include "experiments/figures/blur_curve.h"
#include "experiments/figures/lens_plots.h"
#include "experiments/figures/psf_figures.h"
#include "experiments/figures/wavefront_map.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/values.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr std::size_t spot_rays = 3000;

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
  require_few_panels(targets.size());
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
  require_few_panels(eyes.size());
  std::vector<LensMap> maps;
  for (const PlottedEye& eye : eyes) maps.push_back(wavefront_map(eye.worn.eye, eye.name));
  return lens_map_plot(maps, {1, options.range});
}

double rotation_center(const PlotOptions& options) {
  return metres_per_millimetre * options.rotation_center_mm;
}

Plot draw_power(const PlotOptions& options) {
  const std::vector<NamedLens> lenses = plotted_lenses(options);
  if (options.difference && lenses.size() < 2) throw InputError("", "--difference", "one lens", "at least two lenses");
  require_few_panels(options.difference ? 2 * lenses.size() - 1 : lenses.size());
  return power_plot(lenses, rotation_center(options), options.difference, options.range);
}

Plot draw_defocus(const PlotOptions& options) {
  const std::vector<NamedLens> lenses = plotted_lenses(options);
  require_few_panels(lenses.size());
  const double amplitude_D = amplitude_option(options.worn.age_years, options.worn.amplitude_D);
  return defocus_plot(lenses, rotation_center(options), distances(options, {"0.4"}), amplitude_D, options.range);
}

Plot draw_ellipses(const PlotOptions& options) {
  const std::vector<PlottedEye> eyes = plotted_eyes(options);
  const std::vector<double> targets = distances(options, {"inf"});
  require_few_panels(eyes.size() * targets.size());
  return fields_plot(named_eyes(eyes), targets, options.clear_D, options.range);
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
      return corridor_plot(corridor_profiles(plotted_lenses(options), rotation_center(options)));
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
