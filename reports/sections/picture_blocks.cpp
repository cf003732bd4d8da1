#include "reports/sections/picture_blocks.h"

#include <algorithm>
#include <cmath>

#include "compare/images/image_comparison.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/images/tone_map.h"
#include "reports/markup/false_colour.h"
#include "reports/markup/parts.h"
#include "reports/markup/pictures.h"
#include "reports/viewer/viewer.h"

namespace sturm {

namespace {

constexpr double still_byte_budget = 5.5e6;  ///< that all stills may take as uncompressed base64; PNG is smaller
constexpr double bytes_per_still_pixel = 3.0 * 4.0 / 3.0;
constexpr double viewer_byte_budget = 18.5e6;
constexpr double bytes_per_number = 2.0 * 4.0 / 3.0;
constexpr std::size_t fewest_maps = 3;
constexpr double shown_share = 0.995;  ///< of the pixels, that the ends of the error maps' scale leave inside

struct Prediction {
  std::string key, title, file;
  Image linear, display;
  Image difference;  ///< of the luma in display space from path tracing
};

/// The pictures of one finding, of one size.
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
  bool alone() const { return predictions.size() == 1; }  ///< there is nothing to tell a prediction from
};

Pictures without_pictures(const std::string& problem) {
  Pictures none;
  none.problem = problem;
  return none;
}

bool same_size(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels;
}

Pictures load(const PictureFinding& finding, const std::filesystem::path& run_folder) {
  Pictures result;
  try {
    result.file = finding.path_traced.exr;
    result.linear = main_layer(run_folder / result.file);
    result.display = to_display(result.linear, 1.0);
    const Image luma = luma_image(result.display);
    const bool alone = finding.measures == PictureMeasures::Metrics;
    for (const PredictionFinding& prediction : finding.predictions) {
      const std::string kind = prediction.kind_name();
      Prediction p{
          alone ? "predicted" : kind, alone ? "Predicted" : "Predicted, " + kind, prediction.files.exr, {}, {}, {}};
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

/// One scale for all differences, so that they can be compared with each other.
double error_limit_of(const std::vector<Pictures>& all) {
  std::vector<float> sizes;
  for (const Pictures& pictures : all)
    for (const Prediction& prediction : pictures.predictions)
      for (const float difference : prediction.difference.pixels)
        if (std::isfinite(difference)) sizes.push_back(std::abs(difference));
  if (sizes.empty()) return 1.0;
  const auto nth = sizes.begin() + static_cast<std::ptrdiff_t>(shown_share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), nth, sizes.end());
  return *nth > 0.0f ? round_length_above(*nth) : 1.0;
}

/// Side of the blocks of pixels whose means are to be shown where `bytes` are too many.
int factor_for(double bytes, double budget) {
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(bytes / budget))));
}

/// encode_png refuses numbers that are not finite; the picture shows them in the colour that stands for them.
Image with_visible_defects(Image display) {
  const DisplayColour mark = not_finite_colour();
  for (std::size_t i = 0; i < display.pixels.size(); ++i) {
    if (!std::isfinite(display.pixels[i])) display.pixels[i] = mark[i % 3];
  }
  return display;
}

Html stills(const Pictures& pictures, int factor, double limit) {
  const std::string scale = ", ±" + plain_number(limit);
  const auto still = [&](const Image& display, const std::string& title) {
    return picture_html(with_visible_defects(shrunk(display, factor)), title);
  };
  Html html = still(pictures.display, "Path traced");
  for (const Prediction& p : pictures.predictions)
    html += still(p.display, p.title) + picture_html(diverging_false_colour(shrunk(p.difference, factor), limit),
                                                     p.title + " − path traced" + scale);
  return element("div", {{"class", "three stills"}}, html);
}

/// The maps of a prediction; none but the difference where pictures are too small for metrics or hold numbers that are
/// not finite.
std::vector<ViewerSet::Map> maps_of(const Prediction& p, const Image& traced, double limit, std::size_t most) {
  std::vector<ImageMetric> metrics;
  try {
    metrics = measure_images(p.linear, traced, {});
  } catch (const InputError&) {
    metrics.clear();
  }
  return maps_of_images(p.difference, limit, metrics, most);
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
  return {maps, factor_for(bytes(maps), viewer_byte_budget)};
}

Html place_of(const std::string& title, const Pictures& pictures, const Fit& fit, double limit,
              ViewerPayload& payload) {
  if (pictures.linear.channels != 3 || pictures.predictions.empty()) return {};
  ViewerSet shown;
  shown.title = title;
  shown.factor = fit.factor;
  shown.quantity = viewer_radiance;
  shown.pictures = {{"path_traced", "Path traced", pictures.file}};
  payload.add_picture(pictures.file, pictures.linear, fit.factor);
  Html files = file_link(pictures.file);
  for (const Prediction& p : pictures.predictions) {
    payload.add_picture(p.file, p.linear, fit.factor);
    shown.pictures.push_back({p.key, p.title, p.file});
    for (ViewerSet::Map& map : maps_of(p, pictures.linear, limit, fit.maps)) {
      if (!pictures.alone()) map.of = p.key;
      shown.maps.push_back(std::move(map));
    }
    add_item(files, file_link(p.file));
  }
  share_scales(shown.maps);
  const bool all_maps = fit.maps > viewer_maps().size();
  const std::string predicted = pictures.alone() ? pictures.predictions.front().file : "PREDICTED";
  return viewer_place(payload.add_set(shown)) +
         element("p", {{"class", "made-by"}},
                 "Files: "_html + files + ". "_html + (all_maps ? "Maps"_html : "These and more maps"_html) +
                     " by "_html +
                     inline_element("code", text("sturm compare " + predicted + " " + pictures.file + " --maps maps")) +
                     " in the run's folder."_html);
}

}  // namespace

PictureBlocks picture_blocks(const std::vector<PictureFinding>& findings, const std::filesystem::path& run_folder,
                             ViewerPayload& payload) {
  std::vector<Pictures> all;
  for (const PictureFinding& finding : findings) all.push_back(load(finding, run_folder));
  const Fit fit = fit_of(all);
  const double still_budget = still_byte_budget / static_cast<double>(std::max<std::size_t>(1, all.size()));
  PictureBlocks result{{}, error_limit_of(all)};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Pictures& pictures = all[i];
    if (!pictures.problem.empty()) {
      result.blocks.push_back({missing_html("No pictures: "_html + text(pictures.problem))});
      continue;
    }
    const double still_pixels = pictures.pixels() * (1.0 + 2.0 * static_cast<double>(pictures.predictions.size()));
    const int factor = factor_for(still_pixels * bytes_per_still_pixel, still_budget);
    const std::string title = findings[i].id + " · " + findings[i].model();
    result.blocks.push_back(
        {place_of(title, pictures, fit, result.error_limit, payload) + stills(pictures, factor, result.error_limit),
         factor});
  }
  return result;
}

}  // namespace sturm
