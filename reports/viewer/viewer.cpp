#include "reports/viewer/viewer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/images/half_pixels.h"
#include "io/json/json.h"
#include "io/json/json_text.h"
#include "reports/markup/false_colour.h"
#include "reports/markup/pictures.h"

namespace sturm {

namespace {

/// Share of a map's values that its colours tell apart; the rest has the last colour.
constexpr double shown_share = 0.995;
constexpr int colours_of_a_table = 256;

std::string address(const std::vector<unsigned char>& bytes) {
  return "data:application/octet-stream;base64," + base64(bytes);
}

Json pixels_json(const Image& image) {
  return {{"width", image.width},
          {"height", image.height},
          {"channels", image.channels},
          {"halves", address(half_float_bytes(image.pixels))}};
}

/// Values that may be tiny, times the power of two with which the largest is between 2¹³ and 2¹⁴: so all down to 4e-9
/// of it are normal 16-bit floats, with their full precision.
Json scaled_pixels_json(Image image) {
  constexpr int largest_exponent = 13;
  float largest = 0.0f;
  for (const float value : image.pixels)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const int exponent = largest > 0.0f ? largest_exponent - std::ilogb(largest) : 0;
  for (float& value : image.pixels) value = std::ldexp(value, exponent);
  Json json = pixels_json(image);
  json["exponent"] = exponent;
  return json;
}

/// A map on the whole picture; NaN, which the viewer shows as "no value", where a window does not fit.
Image on_the_picture(const ImageMetric& metric) {
  Image whole(metric.map.width + 2 * metric.margin, metric.map.height + 2 * metric.margin, 1);
  std::fill(whole.pixels.begin(), whole.pixels.end(), std::numeric_limits<float>::quiet_NaN());
  for (int y = 0; y < metric.map.height; ++y)
    for (int x = 0; x < metric.map.width; ++x) *whole.at(x + metric.margin, y + metric.margin) = *metric.map.at(x, y);
  return whole;
}

/// A round end of the map's scale, in its own values (in 1 − value for similarities).
double scale_end(const ImageMetric& metric) {
  std::vector<float> errors;
  for (const float value : metric.map.pixels)
    if (std::isfinite(value)) errors.push_back(metric.map_is_similarity ? 1.0f - value : value);
  if (errors.empty()) return 1.0;
  const auto nth = errors.begin() + static_cast<std::ptrdiff_t>(shown_share * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), nth, errors.end());
  return *nth > 0.0f ? round_length_above(*nth) : 1.0;
}

/// JSON inside HTML that is also XML: no character that either of them would take for markup.
std::string markup_free(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else if (c == '>')
      text += "\\u003e";
    else if (c == '&')
      text += "\\u0026";
    else
      text += c;
  }
  return text;
}

const char* name_of(ViewerSet::Map::Scale scale) {
  constexpr const char* names[] = {"signed", "error", "similarity"};
  return names[static_cast<int>(scale)];
}

template <class ColourAt>
std::string colour_table(const ColourAt& colour_at) {
  std::vector<unsigned char> bytes;
  for (int i = 0; i < colours_of_a_table; ++i)
    for (const float part : colour_at(static_cast<double>(i) / (colours_of_a_table - 1)))
      bytes.push_back(static_cast<unsigned char>(std::lround(255.0f * part)));
  return address(bytes);
}

}  // namespace

const std::vector<std::string>& viewer_maps() {
  // With the two pictures and their difference nine layers: one for each digit key.
  static const std::vector<std::string> keys{"ssim_display", "flip",         "hdr_flip",
                                             "ciede2000",    "relative_mse", "rmse_linear"};
  return keys;
}

std::vector<ViewerSet::Map> maps_of_images(const Image& difference, double difference_limit,
                                           const std::vector<ImageMetric>& metrics, std::size_t most) {
  using Scale = ViewerSet::Map::Scale;
  std::vector<ViewerSet::Map> maps = {
      {"difference", "Predicted − path traced (luma, display space)", difference, difference_limit, Scale::Signed}};
  for (const std::string& key : viewer_maps()) {
    const auto metric =
        std::find_if(metrics.begin(), metrics.end(), [&](const ImageMetric& m) { return m.key == key; });
    if (maps.size() >= most || metric == metrics.end() || metric->map.pixels.empty()) continue;
    const bool squares = key == "rmse_linear";  // whose map holds what is averaged under the root
    maps.push_back({key, squares ? "Squared error, linear" : metric->title, on_the_picture(*metric), scale_end(*metric),
                    metric->map_is_similarity ? Scale::Similarity : Scale::Error});
  }
  return maps;
}

void ViewerPayload::add_picture(const std::string& file, const Image& linear, int factor) {
  if (pictures_.contains(file)) return;
  const Image shown = shrunk(linear, factor);
  pictures_[file] = json_text(shown.channels == 1 ? scaled_pixels_json(shown) : pixels_json(shown));
}

std::size_t ViewerPayload::add_set(const ViewerSet& shown) {
  const bool density = shown.kind == ViewerSet::Kind::Density;
  Json pictures = Json::array(), maps = Json::array();
  for (const ViewerSet::Picture& picture : shown.pictures)
    pictures.push_back({{"key", picture.key}, {"title", picture.title}, {"file", picture.file}});
  for (const ViewerSet::Map& map : shown.maps) {
    const Image values = shrunk(map.values, shown.factor);
    Json json = density ? scaled_pixels_json(values) : pixels_json(values);
    json.update({{"key", map.key}, {"title", map.title}, {"end", map.end}, {"scale", name_of(map.scale)}});
    if (!map.of.empty()) json["of"] = map.of;
    maps.push_back(std::move(json));
  }
  Json item = {{"title", shown.title},   {"kind", density ? "density" : "radiance"}, {"quantity", shown.quantity},
               {"factor", shown.factor}, {"pictures", std::move(pictures)},          {"maps", std::move(maps)}};
  if (density) item["peak"] = shown.peak;
  if (shown.pixel_arcmin) item["pixelArcmin"] = *shown.pixel_arcmin;
  sets_.push_back(json_text(item));
  return sets_.size() - 1;
}

Html ViewerPayload::html() const {
  if (sets_.empty()) return {};
  std::string pictures, cases;
  for (const auto& [file, text] : pictures_) pictures += (pictures.empty() ? "" : ",") + json_text(file) + ":" + text;
  for (const std::string& text : sets_) cases += (cases.empty() ? "" : ",") + text;
  const Json colours = {{"sequential", colour_table([](double t) { return sequential_colour(t); })},
                        {"diverging", colour_table([](double t) { return diverging_colour(2.0 * t - 1.0); })}};
  const std::string document =
      "{\"pictures\":{" + pictures + "},\"cases\":[" + cases + "],\"colours\":" + json_text(colours) + "}";
  return element("script", {{"type", "application/json"}, {"id", "viewer-payload"}},
                 Html::trusted(markup_free(document)));
}

Html viewer_place(std::size_t number) {
  return element("div", {{"class", "viewer"}, {"data-case", std::to_string(number)}}, {});
}

}  // namespace sturm
