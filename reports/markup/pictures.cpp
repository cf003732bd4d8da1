#include "reports/markup/pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "compare/metrics/luma.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/images/exr.h"
#include "io/images/opencv_view.h"
#include "io/images/picture_file.h"
#include "io/images/png_output.h"
#include "reports/markup/false_colour.h"

namespace sturm {

namespace {

constexpr double round_steps[] = {1.0, 2.0, 5.0, 10.0};

/// Pixels along a side, and the means of the blocks that they fall into.
struct Blocks {
  cv::Range pixels, means;
};

/// The whole blocks along a side, and the last one if the border cuts it off.
std::vector<Blocks> blocks_of(int side, int factor) {
  const int whole = side / factor;
  std::vector<Blocks> blocks;
  if (whole > 0) blocks.push_back({{0, whole * factor}, {0, whole}});
  if (side % factor > 0) blocks.push_back({{whole * factor, side}, {whole, whole + 1}});
  return blocks;
}

}  // namespace

std::string base64(const std::vector<unsigned char>& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = bytes[i] << 16;
    if (n > 1) group |= bytes[i + 1] << 8;
    if (n > 2) group |= bytes[i + 2];
    for (std::size_t d = 0; d < 4; ++d) text += d <= n ? digits[(group >> (18 - 6 * d)) & 63] : '=';
  }
  return text;
}

std::string data_uri(const Image& display) {
  return "data:image/png;base64," + base64(encode_png(display));
}

Html picture_html(const Image& display, const std::string& title) {
  const Html picture = empty_element("img", {{"alt", title},
                                             {"width", std::to_string(display.width)},
                                             {"height", std::to_string(display.height)},
                                             {"src", data_uri(display)}});
  return element("figure", element("h4", text(title)) + picture + "\n"_html);
}

Image main_layer(const std::filesystem::path& file) {
  LayeredImage image = read_exr(file);
  const auto main = image.layers.find("");
  if (main == image.layers.end() || main->second.pixels.empty())
    throw InputError(file.string(), "", "", "an image with a main layer");
  return main->second.channels == 4 ? without_alpha(main->second) : std::move(main->second);
}

Image luma_image(const Image& image) {
  const std::vector<double> values = luma(image);
  Image result(image.width, image.height, 1);
  std::transform(values.begin(), values.end(), result.pixels.begin(),
                 [](double value) { return static_cast<float>(value); });
  return result;
}

Image shrunk(const Image& image, int factor) {
  if (factor <= 1) return image;
  Image result((image.width + factor - 1) / factor, (image.height + factor - 1) / factor, image.channels);
  cv::Mat values;
  view(image).convertTo(values, CV_64F);
  for (const Blocks& y : blocks_of(image.height, factor))
    for (const Blocks& x : blocks_of(image.width, factor)) {
      cv::Mat means;
      cv::resize(values(y.pixels, x.pixels), means, {x.means.size(), y.means.size()}, 0.0, 0.0, cv::INTER_AREA);
      means.convertTo(view(result)(y.means, x.means), CV_32F);
    }
  return result;
}

Html svg_ellipse(const Ellipse& ellipse, double pixels_per_unit, double centre_x, double centre_y,
                 const std::string& css_class) {
  // SVG does not draw an ellipse without width; a focal line keeps this much, far below the line that is drawn around
  // it.
  constexpr double narrowest_px = 0.01;
  const std::string x = plain_number(centre_x), y = plain_number(centre_y);
  Attributes attributes = {{"class", css_class},
                           {"cx", x},
                           {"cy", y},
                           {"rx", plain_number(std::max(narrowest_px, ellipse.semi_major * pixels_per_unit))},
                           {"ry", plain_number(std::max(narrowest_px, ellipse.semi_minor * pixels_per_unit))}};
  if (ellipse.orientation_deg)
    attributes.push_back(
        {"transform", "rotate(" + plain_number(0.0 - *ellipse.orientation_deg) + " " + x + " " + y + ")"});
  return empty_element("ellipse", attributes) + "\n"_html;
}

double round_length_below(double longest) {
  const double decade = std::pow(10.0, std::floor(std::log10(longest)));
  double best = decade;
  for (const double step : round_steps) {
    if (step * decade <= longest) best = step * decade;
  }
  return best;
}

double round_length_above(double shortest) {
  const double decade = std::pow(10.0, std::floor(std::log10(shortest)));
  for (const double step : round_steps) {
    if (step * decade >= shortest) return step * decade;
  }
  return 10.0 * decade;
}

Html colour_bar_svg(ColourMap map, const std::vector<ColourTick>& ticks, const std::string& title) {
  constexpr int width = 360, height = 14, margin = 30, stops = 33;
  const std::string gradient = map == ColourMap::Sequential ? "sequential-colours" : "diverging-colours";
  Html body;
  for (int i = 0; i < stops; ++i) {
    const double t = static_cast<double>(i) / (stops - 1);
    const DisplayColour colour = map == ColourMap::Sequential ? sequential_colour(t) : diverging_colour(2 * t - 1);
    body += empty_element("stop", {{"offset", plain_number(t)}, {"stop-color", hex_colour(colour)}});
  }
  body = element("linearGradient", {{"id", gradient}}, body);
  body += empty_element("rect", {{"x", std::to_string(margin)},
                                 {"y", "20"},
                                 {"width", std::to_string(width)},
                                 {"height", std::to_string(height)},
                                 {"fill", "url(#" + gradient + ")"}});
  body += inline_element("text", {{"x", std::to_string(margin)}, {"y", "13"}}, text(title));
  for (const ColourTick& tick : ticks) {
    const std::string x = plain_number(margin + tick.position * width);
    body += empty_element("path", {{"class", "tick"}, {"d", "M" + x + " 34v4"}});
    body += inline_element("text", {{"x", x}, {"y", "51"}, {"text-anchor", "middle"}}, text(tick.label));
  }
  return element("svg",
                 {{"class", "bar"},
                  {"viewBox", "0 0 " + std::to_string(width + 2 * margin) + " 56"},
                  {"role", "img"},
                  {"aria-label", "Colour bar: " + title}},
                 body);
}

}  // namespace sturm
