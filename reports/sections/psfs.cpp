#include <algorithm>
#include <cmath>
#include <vector>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "reports/markup/false_colour.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/markup/pictures.h"
#include "reports/sections/command.h"
#include "reports/sections/sections.h"
#include "reports/sections/spreads.h"

namespace sturm {

namespace {

constexpr double shown_decades = 2.0;

/// Semi-axes in arcmin, as the report has them.
std::optional<Ellipse> ellipse_at(const Json& json) {
  const auto major = number_at(json, "semi_axes_arcmin/0"), minor = number_at(json, "semi_axes_arcmin/1");
  if (!major || !minor) return std::nullopt;
  return Ellipse{*major, *minor, number_at(json, "orientation_deg")};
}

Html scale_bar(int width, int height, double pixel_arcmin) {
  const double length_arcmin = round_length_below(0.3 * width * pixel_arcmin);
  const double length = length_arcmin / pixel_arcmin, x = 0.05 * width, y = 0.95 * height;
  return empty_element("path", {{"class", "scale"},
                                {"d", "M" + plain_number(x) + " " + plain_number(y) + "h" + plain_number(length)}}) +
         inline_element("text",
                        {{"class", "scale"},
                         {"x", plain_number(x)},
                         {"y", plain_number(y - 0.02 * height)},
                         {"font-size", plain_number(0.05 * height)}},
                        text(plain_number(length_arcmin) + " arcmin"));
}

Html picture(const Json& psf, const std::filesystem::path& run_folder) {
  const Image values = luma_image(main_layer(run_folder / text_at(psf, "file")));
  const double peak = *std::max_element(values.pixels.begin(), values.pixels.end());
  const Image colours = sequential_false_colour(values, {.peak = peak > 0.0 ? peak : 1.0, .decades = shown_decades});
  const std::string width = std::to_string(values.width), height = std::to_string(values.height);
  Html body = empty_element("image", {{"width", width}, {"height", height}, {"href", data_uri(colours)}}) + "\n"_html;
  if (const auto pixel_arcmin = number_at(psf, "pixel_arcmin"); pixel_arcmin && *pixel_arcmin > 0.0) {
    for (const char* which : {"predicted", "measured"}) {
      const auto ellipse = ellipse_at(value_at(psf, which));
      if (ellipse) body += svg_ellipse(*ellipse, 1.0 / *pixel_arcmin, 0.5 * values.width, 0.5 * values.height, which);
    }
    body += scale_bar(values.width, values.height, *pixel_arcmin);
  }
  return element("svg",
                 {{"class", "psf"},
                  {"viewBox", "0 0 " + width + " " + height},
                  {"role", "img"},
                  {"aria-label", "Point-spread function with the predicted and the measured ellipse"}},
                 body);
}

/// A semi-axis with its uncertainty on a line of its own, which keeps the table as narrow as the picture.
Html semi_axis_html(const Json& ellipse, const std::string& index) {
  return stacked_html(number_at(ellipse, "semi_axes_arcmin/" + index),
                      number_at(ellipse, "standard_error_arcmin/" + index));
}

Html numbers(const Json& psf) {
  HtmlTable table("Semi-axes and orientation", "",
                  {{"Ellipse"_html, false}, {"Major [arcmin]"_html}, {"Minor [arcmin]"_html}, {"Angle [°]"_html}});
  const auto row = [&](const char* key, const Html& name) {
    const Json& ellipse = value_at(psf, key);
    if (!ellipse.is_object()) return;
    table.add_row({name, semi_axis_html(ellipse, "0"), semi_axis_html(ellipse, "1"),
                   number_html(number_at(ellipse, "orientation_deg"), 3)});
  };
  row("predicted", "<span class=\"key predicted\"></span>predicted"_html);
  row("measured", "<span class=\"key measured\"></span>measured"_html);
  row("bundle", "ray bundle"_html);
  return table.html();
}

Html figure(const Json& psf, const std::filesystem::path& run_folder) {
  Html html;
  try {
    html = picture(psf, run_folder);
  } catch (const InputError& error) {
    html = missing_html("No picture: "_html + text(error.what()));
  }
  Html hits;
  if (const auto count = number_at(psf, "measured/hits")) hits = " · "_html + count_html(count) + " rays hit"_html;
  return element("figure", element("h4", code_html(text_at(psf, "ray_model")) + hits) + html + numbers(psf));
}

Html group_heading(const Json& psf) {
  return text_or_dash(text_at(psf, "id")) + " "_html +
         small_html(text_or_dash(text_at(psf, "prescription")) + " · "_html +
                    distance_html(value_at(psf, "distance_m")) + " m · pupil "_html +
                    exact_html(number_at(psf, "pupil_mm")) + " mm"_html);
}

/// The pictures of one id: what the conoid predicts, and the path-traced ones by ray model.
SpreadGroup group_of(const Json& psfs, const std::string& id) {
  SpreadGroup group;
  group.title = id;
  group.quantity = "share of the pupil through which a pixel sees the light";
  for (const Json& psf : psfs) {
    if (text_at(psf, "id") != id) continue;
    const std::string model = text_at(psf, "ray_model"), predicted = text_at(psf, "files/predicted");
    const auto pixel_arcmin = number_at(psf, "pixel_arcmin"), pixels = number_at(psf, "resolution");
    if (!group.truth && !predicted.empty()) group.truth = {"predicted", "predicted", predicted};
    if (pixel_arcmin && pixels) group.side_arcmin = *pixel_arcmin * *pixels;
    group.spreads.push_back({model, model, text_at(psf, "file")});
  }
  return group;
}

}  // namespace

Html psf_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  const Json& psfs = array_at(report, "psfs");
  if (psfs.empty()) return {};
  std::vector<std::string> ids;  // in the order of the report; one group per id, one picture per ray model
  for (const Json& psf : psfs) {
    if (std::find(ids.begin(), ids.end(), text_at(psf, "id")) == ids.end()) ids.push_back(text_at(psf, "id"));
  }
  Html html =
      element("h2", "Point-spread functions"_html) +
      element("p",
              "Path-traced images of a point-like light on the line of sight, seen by the wearer (x to the wearer's "
              "right, y up). "
              "<span class=\"key predicted\"></span>Solid: the ellipse predicted by the conoid. "
              "<span class=\"key measured\"></span>Dashed: the ellipse with the second moments of the picture. "
              "Orientations are counter-clockwise from the horizontal."_html) +
      colour_bar_svg(ColourMap::Sequential, {{0.0, "≤ 1/100"}, {0.5, "1/10"}, {1.0, "1"}},
                     "Radiance relative to each picture's peak (logarithmic)");
  std::vector<SpreadGroup> groups;
  for (const std::string& id : ids) groups.push_back(group_of(psfs, id));
  const std::vector<Html> viewers = spread_viewers(groups, run_folder, payload);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::string& id = ids[i];
    Html figures;
    const Json* first = nullptr;
    for (const Json& psf : psfs) {
      if (text_at(psf, "id") != id) continue;
      if (!first) first = &psf;
      figures += figure(psf, run_folder);
    }
    html += element(
        "article", element("h3", group_heading(*first)) + element("div", {{"class", "gallery"}}, figures) + viewers[i]);
  }
  return element("section", {{"id", "psfs"}}, html + made_by(report));
}

}  // namespace sturm
