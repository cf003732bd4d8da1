#include "reports/sections/agreement_pictures.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/images/image_comparison.h"
#include "io/files/error.h"
#include "io/images/tone_map.h"
#include "io/json/stored.h"
#include "reports/markup/false_colour.h"
#include "reports/markup/parts.h"
#include "reports/markup/pictures.h"
#include "reports/viewer/viewer.h"

namespace sturm {

namespace {

constexpr double error_limit = 0.1;          ///< of the differences, luma in display space
constexpr double still_byte_budget = 5.5e6;  ///< that all stills may take as uncompressed base64
constexpr double bytes_per_still_pixel = 4.0;
constexpr double viewer_byte_budget = 18.5e6;
constexpr double bytes_per_number = 2.0 * 4.0 / 3.0;
constexpr std::size_t fewest_maps = 3;

struct Prediction {
  std::string kind, file;
  Image linear, display;
  Image difference;  ///< of the luma in display space from path tracing
};

/// The pictures of one entry, of one size.
struct Pictures {
  std::string file;  ///< of the path-traced one
  Image linear, display;
  std::vector<Prediction> predictions;
  std::string problem;  ///< why there are none; plain text

  double pixels() const { return static_cast<double>(linear.width) * linear.height; }
  double numbers(std::size_t maps) const {
    const auto kinds = static_cast<double>(predictions.size());
    return problem.empty() ? pixels() * (3.0 + kinds * (3.0 + static_cast<double>(maps))) : 0.0;
  }
};

Pictures without_pictures(const std::string& problem) {
  Pictures none;
  none.problem = problem;
  return none;
}

bool same_size(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels;
}

Pictures load(const Json& entry, const std::filesystem::path& run_folder) {
  Pictures result;
  try {
    result.file = text_at(entry, "files/path_traced");
    result.linear = main_layer(run_folder / result.file);
    result.display = to_display(result.linear, 1.0);
    const Image luma = luma_image(result.display);
    for (const Json& prediction : array_at(entry, "predictions")) {
      Prediction p{text_at(prediction, "kind"), text_at(prediction, "files/predicted"), {}, {}, {}};
      p.linear = main_layer(run_folder / p.file);
      if (!same_size(p.linear, result.linear)) return without_pictures("they differ in size");
      p.display = to_display(p.linear, 1.0);
      p.difference = luma_image(p.display);
      for (std::size_t i = 0; i < luma.pixels.size(); ++i) p.difference.pixels[i] -= luma.pixels[i];
      result.predictions.push_back(std::move(p));
    }
  } catch (const InputError& error) {
    return without_pictures(error.what());
  }
  return result;
}

Html stills(const Pictures& pictures, double budget) {
  const double pixels = pictures.pixels() * (1.0 + 2.0 * static_cast<double>(pictures.predictions.size()));
  const int factor = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels * bytes_per_still_pixel / budget))));
  Html html = picture_html(shrunk(pictures.display, factor), "Path traced");
  for (const Prediction& p : pictures.predictions)
    html += picture_html(shrunk(p.display, factor), "Predicted, " + p.kind) +
            picture_html(diverging_false_colour(shrunk(p.difference, factor), error_limit),
                         p.kind + " − path traced, ±0.1");
  return element("div", {{"class", "three stills"}}, html);
}

/// The maps of a prediction; none but the difference where pictures are too small for metrics or hold numbers that are
/// not finite.
std::vector<ViewerSet::Map> maps_of(const Prediction& p, const Image& traced, std::size_t most) {
  std::vector<ImageMetric> metrics;
  try {
    metrics = measure_images(p.linear, traced, {});
  } catch (const InputError&) {
    metrics.clear();
  }
  std::vector<ViewerSet::Map> maps = maps_of_images(p.difference, error_limit, metrics, most);
  for (ViewerSet::Map& map : maps) map.of = p.kind;
  return maps;
}

/// Gives maps of one kind one scale, so that the predictions can be compared with each other.
void share_scales(std::vector<ViewerSet::Map>& maps) {
  for (ViewerSet::Map& map : maps)
    for (const ViewerSet::Map& other : maps)
      if (other.key == map.key) map.end = std::max(map.end, other.end);
}

/// How much of the maps and of the resolution fits the page.
struct Fit {
  std::size_t maps;
  int factor;
};

Fit fit_of(const std::vector<Pictures>& all) {
  const auto bytes = [&](std::size_t maps) {
    double numbers = 0.0;
    for (const Pictures& pictures : all) numbers += pictures.numbers(maps);
    return numbers * bytes_per_number;
  };
  std::size_t maps = 1 + viewer_maps().size();
  while (maps > fewest_maps && bytes(maps) > viewer_byte_budget) --maps;
  return {maps, std::max(1, static_cast<int>(std::ceil(std::sqrt(bytes(maps) / viewer_byte_budget))))};
}

Html place_of(const std::string& id, const Pictures& pictures, const Fit& fit, ViewerPayload& payload) {
  if (pictures.linear.channels != 3 || pictures.predictions.empty()) return {};
  ViewerSet shown;
  shown.title = id;
  shown.factor = fit.factor;
  shown.quantity = viewer_radiance;
  shown.pictures = {{"path_traced", "Path traced", pictures.file}};
  payload.add_picture(pictures.file, pictures.linear, fit.factor);
  Html files = file_link(pictures.file);
  for (const Prediction& p : pictures.predictions) {
    payload.add_picture(p.file, p.linear, fit.factor);
    shown.pictures.push_back({p.kind, "Predicted, " + p.kind, p.file});
    for (ViewerSet::Map& map : maps_of(p, pictures.linear, fit.maps)) shown.maps.push_back(std::move(map));
    add_item(files, file_link(p.file));
  }
  share_scales(shown.maps);
  const bool all_maps = fit.maps > viewer_maps().size();
  return viewer_place(payload.add_set(shown)) +
         element("p", {{"class", "made-by"}},
                 "Files: "_html + files + ". "_html + (all_maps ? "Maps"_html : "These and more maps"_html) +
                     " by "_html +
                     inline_element("code", text("sturm compare PREDICTED " + pictures.file + " --maps maps")) +
                     " in the run's folder."_html);
}

}  // namespace

std::vector<Html> agreement_pictures(const Json& entries, const std::filesystem::path& run_folder,
                                     ViewerPayload& payload) {
  std::vector<Pictures> all;
  for (const Json& entry : entries) all.push_back(load(entry, run_folder));
  const Fit fit = fit_of(all);
  const double still_budget = still_byte_budget / static_cast<double>(std::max<std::size_t>(1, all.size()));
  std::vector<Html> html;
  for (std::size_t i = 0; i < all.size(); ++i)
    html.push_back(all[i].problem.empty()
                       ? place_of(text_at(entries[i], "id"), all[i], fit, payload) + stills(all[i], still_budget)
                       : missing_html("No pictures: "_html + text(all[i].problem)));
  return html;
}

}  // namespace sturm
