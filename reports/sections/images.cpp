#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "compare/images/image_comparison.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/images/tone_map.h"
#include "io/json/stored.h"
#include "reports/markup/false_colour.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/markup/pictures.h"
#include "reports/sections/command.h"
#include "reports/sections/sections.h"
#include "reports/viewer/viewer.h"

namespace sturm {

namespace {

/// Bytes that all image pairs together may take as uncompressed 8-bit RGB in base64; PNG only makes them smaller.
constexpr double byte_budget = 5e6;
constexpr double bytes_per_pixel = 3.0 * 4.0 / 3.0;

/// Share of the pixels that the ends of the error map's scale leave inside.
constexpr double shown_share = 0.995;

/// Bytes that the viewer's numbers may take on the page: two pictures of 3 channels and 7 maps per case, 2 bytes each
/// in base64.
constexpr double viewer_byte_budget = 10e6;
constexpr double viewer_bytes_per_pixel = (2 * 3 + 7) * 2.0 * 4.0 / 3.0;

struct Pair {
  Image path_traced, predicted;  ///< display-referred
  Image difference;              ///< luma, predicted − path traced, in display space
  Image linear_traced, linear_predicted;
  std::string problem;  ///< why there are no pictures; plain text
};

Pair load_pair(const Json& entry, const std::filesystem::path& run_folder) {
  try {
    const Image traced = main_layer(run_folder / text_at(entry, "files/path_traced"));
    const Image predicted = main_layer(run_folder / text_at(entry, "files/predicted"));
    if (traced.width != predicted.width || traced.height != predicted.height || traced.channels != predicted.channels) {
      return {{}, {}, {}, {}, {}, "the two images differ in size"};
    }
    Pair pair{to_display(traced, 1.0), to_display(predicted, 1.0), {}, traced, predicted, ""};
    const Image a = luma_image(pair.path_traced);
    pair.difference = luma_image(pair.predicted);
    for (std::size_t i = 0; i < a.pixels.size(); ++i) pair.difference.pixels[i] -= a.pixels[i];
    return pair;
  } catch (const InputError& error) {
    return {{}, {}, {}, {}, {}, error.what()};
  }
}

/// One scale for all error maps of the report, so that they can be compared with each other.
double error_limit(const std::vector<Pair>& pairs) {
  std::vector<float> sizes;
  for (const Pair& pair : pairs) {
    for (const float difference : pair.difference.pixels) {
      if (std::isfinite(difference)) sizes.push_back(std::abs(difference));
    }
  }
  if (sizes.empty()) return 1.0;
  const auto nth = sizes.begin() + static_cast<std::ptrdiff_t>(shown_share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), nth, sizes.end());
  return *nth > 0.0f ? round_length_above(*nth) : 1.0;
}

/// Side of the blocks of pixels whose means fit `budget` when `count` pictures of this size take `bytes` per pixel.
int shrink_factor(const Image& image, std::size_t count, double bytes, double budget) {
  const double pixels = static_cast<double>(image.width) * image.height * static_cast<double>(count);
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels * bytes / budget))));
}

/// The metrics of a pair with their maps; none where the pictures are too small for them or hold numbers that are not
/// finite.
std::vector<ImageMetric> maps_of(const Pair& pair) {
  try {
    return measure_images(pair.linear_predicted, pair.linear_traced, {});
  } catch (const InputError&) {
    return {};
  }
}

/// Gives the case to the viewer; its place on the page.
Html place_of(const Json& entry, const Pair& pair, double limit, std::size_t cases, ViewerPayload& payload) {
  const std::string traced = text_at(entry, "files/path_traced"), predicted = text_at(entry, "files/predicted");
  if (pair.linear_traced.channels != 3) return {};
  const int factor = shrink_factor(pair.linear_traced, cases, viewer_bytes_per_pixel, viewer_byte_budget);
  payload.add_picture(traced, pair.linear_traced, factor);
  payload.add_picture(predicted, pair.linear_predicted, factor);
  const std::size_t number =
      payload.add_set(set_of_images(text_at(entry, "id") + " · " + text_at(entry, "ray_model"), traced, predicted,
                                    pair.difference, limit, maps_of(pair), factor));
  return viewer_place(number) +
         element("p", {{"class", "made-by"}},
                 "Files: "_html + file_link(traced) + ", "_html + file_link(predicted) + ". Maps by "_html +
                     inline_element("code", text("sturm compare " + predicted + " " + traced + " --maps maps")) +
                     " in the run's folder."_html);
}

/// encode_png refuses numbers that are not finite; the picture shows them in the colour that stands for them.
Image with_visible_defects(Image display) {
  const DisplayColour mark = not_finite_colour();
  for (std::size_t i = 0; i < display.pixels.size(); ++i) {
    if (!std::isfinite(display.pixels[i])) display.pixels[i] = mark[i % 3];
  }
  return display;
}

Html floor_html(const Json& entry, const std::string& metric) {
  const auto floor = number_at(entry, "noise_floor/" + metric);
  return floor ? small_html("floor "_html + number_html(floor, 3)) : Html();
}

Html metric_html(const Json& entry, const std::string& metric) {
  const Json& value = value_at(entry, "metrics/" + metric);
  const Html html = value.is_object() ? measured_html(number_at(value, "value"), number_at(value, "uncertainty"))
                                      : number_html(number_at(value, ""), 3);
  return html + floor_html(entry, metric);
}

Html speed_up_html(const Json& entry) {
  const auto slow = number_at(entry, "seconds/path_traced"), fast = number_at(entry, "seconds/predicted_total");
  return slow && fast && *fast > 0.0 ? "× "_html + number_html(*slow / *fast, 2) : absent_html();
}

Html predicted_seconds_html(const Json& entry) {
  const auto sharp = number_at(entry, "seconds/sharp_view"), spreading = number_at(entry, "seconds/spreading");
  Html html = number_html(number_at(entry, "seconds/predicted_total"), 3);
  if (sharp && spreading)
    html += small_html("sharp view "_html + number_html(sharp, 2)) +
            small_html("spreading "_html + number_html(spreading, 2));
  return html;
}

Html metrics_table(const Json& images) {
  HtmlTable table("Path traced against predicted", "metrics",
                  {{"Image"_html, false},
                   {"Ray model"_html, false},
                   {"SSIM, display"_html},
                   {"SSIM, linear"_html},
                   {"PSNR, display [dB]"_html},
                   {"RMSE, linear"_html},
                   {"Relative MSE"_html},
                   {"Path traced [s]"_html},
                   {"Predicted [s]"_html},
                   {"Faster"_html}});
  for (const Json& entry : images) {
    table.add_row({text_or_dash(text_at(entry, "id")), code_html(text_at(entry, "ray_model")),
                   metric_html(entry, "ssim_display"), metric_html(entry, "ssim_linear"),
                   metric_html(entry, "psnr_display_dB"), metric_html(entry, "rmse_linear"),
                   metric_html(entry, "relative_mse"), number_html(number_at(entry, "seconds/path_traced"), 3),
                   predicted_seconds_html(entry), speed_up_html(entry)});
  }
  return table.html();
}

Html article(const Json& entry, const Pair& pair, double limit, std::size_t cases, ViewerPayload& payload) {
  Html conditions = text_or_dash(text_at(entry, "scene")) + " · "_html + text_or_dash(text_at(entry, "prescription")) +
                    " · pupil "_html + exact_html(number_at(entry, "pupil_mm")) + " mm · "_html +
                    count_html(number_at(entry, "samples_per_pixel")) + " samples per pixel"_html;
  Html body;
  if (pair.problem.empty()) {
    const int factor = shrink_factor(pair.path_traced, 3 * cases, bytes_per_pixel, byte_budget);
    if (factor > 1) conditions += " · shown at 1/"_html + text(std::to_string(factor)) + " of its size"_html;
    body = place_of(entry, pair, limit, cases, payload) +
           element("div", {{"class", "three stills"}},
                   picture_html(with_visible_defects(shrunk(pair.path_traced, factor)), "Path traced") +
                       picture_html(with_visible_defects(shrunk(pair.predicted, factor)), "Predicted") +
                       picture_html(diverging_false_colour(shrunk(pair.difference, factor), limit),
                                    "Predicted − path traced"));
  } else {
    body = missing_html("No pictures: "_html + text(pair.problem));
  }
  const Html heading = text_or_dash(text_at(entry, "id")) + " · "_html + code_html(text_at(entry, "ray_model")) +
                       " "_html + small_html(conditions);
  return element("article", element("h3", heading) + body);
}

}  // namespace

Html image_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  const Json& images = array_at(report, "images");
  if (images.empty()) return {};
  std::vector<Pair> pairs;
  for (const Json& entry : images) pairs.push_back(load_pair(entry, run_folder));
  const double limit = error_limit(pairs);
  const std::string end = plain_number(limit), half = plain_number(0.5 * limit);
  Html html =
      element("h2", "Images"_html) +
      element("p",
              "The same view, path traced through the eye and predicted from one sharp view. <i>Floor</i> is the same "
              "metric between the "
              "two halves of the path-traced replicates, each with half of the samples: the path tracer against its "
              "own noise. Display "
              "means sRGB, clamped to 0 … 1."_html) +
      metrics_table(images) +
      colour_bar_svg(ColourMap::Diverging, {{0.0, "−" + end}, {0.25, "−" + half}, {0.5, "0"}, {0.75, half}, {1.0, end}},
                     "Predicted − path traced, luma in display space (one scale for all)");
  for (std::size_t i = 0; i < images.size(); ++i) html += article(images[i], pairs[i], limit, images.size(), payload);
  return element("section", {{"id", "images"}}, html + made_by(report));
}

}  // namespace sturm
