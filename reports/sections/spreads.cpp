#include "reports/sections/spreads.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "reports/markup/parts.h"
#include "reports/markup/pictures.h"
#include "reports/viewer/viewer.h"

namespace sturm {

namespace {

/// Bytes of the page that the numbers of a section may take; each takes 2 bytes in base64.
constexpr double byte_budget = 3e6;
constexpr double bytes_per_pixel = 2.0 * 4.0 / 3.0;

struct Loaded {
  SpreadGroup::Spread spread;
  Image density;
};

struct LoadedGroup {
  std::vector<Loaded> pictures;
  bool has_truth = false;  ///< which then is the first

  double numbers() const {
    double sum = 0.0;
    for (const Loaded& picture : pictures) sum += static_cast<double>(picture.density.pixels.size());
    return has_truth ? 2.0 * sum : sum;
  }
};

void load(const SpreadGroup::Spread& spread, const std::filesystem::path& run_folder, std::vector<Loaded>& pictures) {
  try {
    Image density = luma_image(main_layer(run_folder / spread.file));
    const bool fits = pictures.empty() ||
                      (density.width == pictures[0].density.width && density.height == pictures[0].density.height);
    if (fits) pictures.push_back({spread, std::move(density)});
  } catch (const InputError&) {
    // The still of the same file says what is wrong with it.
  }
}

LoadedGroup loaded(const SpreadGroup& group, const std::filesystem::path& run_folder) {
  LoadedGroup result;
  if (group.truth) load(*group.truth, run_folder, result.pictures);
  result.has_truth = !result.pictures.empty();
  for (const SpreadGroup::Spread& spread : group.spreads) load(spread, run_folder, result.pictures);
  return result;
}

float largest_of(const Image& image) {
  float largest = 0.0f;
  for (const float value : image.pixels)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

Image minus(Image a, const Image& b) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] -= b.pixels[i];
  return a;
}

/// The differences on one scale, so that they can be compared with each other.
std::vector<ViewerSet::Map> differences(const std::vector<Loaded>& pictures, int factor) {
  std::vector<ViewerSet::Map> maps;
  float largest = 0.0f;
  for (std::size_t i = 1; i < pictures.size(); ++i) {
    Image difference = minus(pictures[i].density, pictures[0].density);
    largest = std::max(largest, largest_of(shrunk(difference, factor)));
    maps.push_back({"difference_" + pictures[i].spread.key, pictures[i].spread.title + " − " + pictures[0].spread.title,
                    std::move(difference), 1.0, ViewerSet::Map::Scale::Signed});
  }
  for (ViewerSet::Map& map : maps) map.end = largest > 0.0f ? round_length_above(largest) : 1.0;
  return maps;
}

Html place_of(const SpreadGroup& group, const LoadedGroup& loaded, int factor, ViewerPayload& payload) {
  if (loaded.pictures.empty()) return {};
  ViewerSet shown;
  shown.title = group.title;
  shown.kind = ViewerSet::Kind::Density;
  shown.factor = factor;
  shown.quantity = group.quantity;
  if (group.side_arcmin) shown.pixel_arcmin = *group.side_arcmin / loaded.pictures[0].density.width;
  Html files;
  for (const Loaded& picture : loaded.pictures) {
    payload.add_picture(picture.spread.file, picture.density, factor);
    shown.pictures.push_back({picture.spread.key, picture.spread.title, picture.spread.file});
    shown.peak = std::max(shown.peak, static_cast<double>(largest_of(shrunk(picture.density, factor))));
    add_item(files, file_link(picture.spread.file));
  }
  if (!(shown.peak > 0.0)) shown.peak = 1.0;  // all black
  if (loaded.has_truth) shown.maps = differences(loaded.pictures, factor);
  return viewer_place(payload.add_set(shown)) + element("p", {{"class", "made-by"}}, "Files: "_html + files + "."_html);
}

}  // namespace

std::vector<Html> spread_viewers(const std::vector<SpreadGroup>& groups, const std::filesystem::path& run_folder,
                                 ViewerPayload& payload) {
  std::vector<LoadedGroup> all;
  double numbers = 0.0;
  for (const SpreadGroup& group : groups) {
    all.push_back(loaded(group, run_folder));
    numbers += all.back().numbers();
  }
  const int factor = std::max(1, static_cast<int>(std::ceil(std::sqrt(numbers * bytes_per_pixel / byte_budget))));
  std::vector<Html> places;
  for (std::size_t i = 0; i < groups.size(); ++i) places.push_back(place_of(groups[i], all[i], factor, payload));
  return places;
}

}  // namespace sturm
