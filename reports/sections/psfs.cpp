#include "compare/findings/psfs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/json/stored_values.h"
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

Html picture(const PsfFinding& psf, const std::filesystem::path& run_folder) {
  const Image values = luma_image(main_layer(run_folder / psf.file));
  const double peak = *std::max_element(values.pixels.begin(), values.pixels.end());
  const Image colours = sequential_false_colour(values, {.peak = peak > 0.0 ? peak : 1.0, .decades = shown_decades});
  const std::string width = std::to_string(values.width), height = std::to_string(values.height);
  Html body = empty_element("image", {{"width", width}, {"height", height}, {"href", data_uri(colours)}}) + "\n"_html;
  if (const Number& pixel_arcmin = psf.pixel_arcmin; pixel_arcmin && *pixel_arcmin > 0.0) {
    const auto add = [&](const std::optional<Ellipse>& ellipse, const char* which) {
      if (ellipse) body += svg_ellipse(*ellipse, 1.0 / *pixel_arcmin, 0.5 * values.width, 0.5 * values.height, which);
    };
    add(psf.predicted, "predicted");
    add(psf.measured ? psf.measured->ellipse : std::nullopt, "measured");
    body += scale_bar(values.width, values.height, *pixel_arcmin);
  }
  return element("svg",
                 {{"class", "psf"},
                  {"viewBox", "0 0 " + width + " " + height},
                  {"role", "img"},
                  {"aria-label", "Point-spread function with the predicted and the measured ellipse"}},
                 body);
}

/// Semi-axes with their uncertainties on lines of their own, which keeps the table as narrow as the picture.
void add_row(const Html& name, const std::optional<Ellipse>& e, const std::optional<Eigen::Vector2d>& error,
             HtmlTable& table) {
  table.add_row({name,
                 stacked_html(e ? Number(e->semi_major) : std::nullopt, error ? Number(error->x()) : std::nullopt),
                 stacked_html(e ? Number(e->semi_minor) : std::nullopt, error ? Number(error->y()) : std::nullopt),
                 number_html(e ? e->orientation_deg : std::nullopt, 3)});
}

Html numbers(const PsfFinding& psf) {
  HtmlTable table("Semi-axes and orientation", "",
                  {{"Ellipse"_html, false}, {"Major [arcmin]"_html}, {"Minor [arcmin]"_html}, {"Angle [°]"_html}});
  if (psf.predicted) add_row("<span class=\"key predicted\"></span>predicted"_html, psf.predicted, std::nullopt, table);
  if (psf.measured)
    add_row("<span class=\"key measured\"></span>measured"_html, psf.measured->ellipse,
            psf.measured->standard_error_arcmin, table);
  if (psf.bundle) add_row("ray bundle"_html, psf.bundle, std::nullopt, table);
  return table.html();
}

Html figure(const PsfFinding& psf, const std::filesystem::path& run_folder) {
  Html html;
  try {
    html = picture(psf, run_folder);
  } catch (const InputError& error) {
    html = missing_html("No picture: "_html + text(error.what()));
  }
  Html hits;
  if (const Number count = psf.measured ? psf.measured->hits : std::nullopt)
    hits = " · "_html + count_html(count) + " rays hit"_html;
  return element("figure", element("h4", code_html(name_of(psf.ray_model)) + hits) + html + numbers(psf));
}

Html group_heading(const PsfFinding& psf) {
  return text_or_dash(psf.id) + " "_html +
         small_html(text_or_dash(psf.prescription) + " · "_html + distance_html(psf.distance_m) + " m · pupil "_html +
                    exact_html(psf.pupil_mm) + " mm"_html);
}

/// The pictures of one id: what the conoid predicts, and the path-traced ones by ray model.
SpreadGroup group_of(const std::vector<PsfFinding>& psfs, const std::string& id) {
  SpreadGroup group;
  group.title = id;
  group.quantity = "share of the pupil through which a pixel sees the light";
  for (const PsfFinding& psf : psfs) {
    if (psf.id != id) continue;
    const std::string model = name_of(psf.ray_model);
    if (!group.truth && !psf.predicted_file.empty()) group.truth = {"predicted", "predicted", psf.predicted_file};
    if (psf.pixel_arcmin && psf.resolution)
      group.side_arcmin = *psf.pixel_arcmin * static_cast<double>(*psf.resolution);
    group.spreads.push_back({model, model, psf.file});
  }
  return group;
}

}  // namespace

Html psf_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  const std::vector<PsfFinding> psfs = read_psfs(report);
  if (psfs.empty()) return {};
  std::vector<std::string> ids;  // in the order of the report; one group per id, one picture per ray model
  for (const PsfFinding& psf : psfs) {
    if (std::find(ids.begin(), ids.end(), psf.id) == ids.end()) ids.push_back(psf.id);
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
    const PsfFinding* first = nullptr;
    for (const PsfFinding& psf : psfs) {
      if (psf.id != id) continue;
      if (!first) first = &psf;
      figures += figure(psf, run_folder);
    }
    html += element(
        "article", element("h3", group_heading(*first)) + element("div", {{"class", "gallery"}}, figures) + viewers[i]);
  }
  return element("section", {{"id", "psfs"}}, html + made_by(report));
}

}  // namespace sturm
