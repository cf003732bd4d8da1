#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/formatted_text.h"
#include "reports/markup/drawing.h"
#include "reports/markup/false_colour.h"
#include "reports/markup/pictures.h"
#include "reports/sections/sin2_study/figures.h"

namespace sturm {

namespace {

struct Column {
  const char *model, *title;
};
constexpr std::array<Column, 4> columns{{{"wavefront", "wavefront theory"},
                                         {"sin2_radial", "sin²"},
                                         {"repaired", "sin² + tangential term"},
                                         {"metalstigmatism", "focal distances added"}}};

constexpr double gallery_left = 250.0, gallery_top = 44.0, gallery_side = 200.0, gallery_gap = 14.0;
constexpr double decades = 3.0;

/// Null where a view has no such model.
const Sin2Spread* of_model(const Sin2GalleryEntry& view, const std::string& model) {
  for (const Sin2Spread& entry : view.models)
    if (entry.model == model) return &entry;
  return nullptr;
}

Image one_channel(const Image& image) {
  Image result(image.width, image.height, 1);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = image.pixels[i * static_cast<std::size_t>(image.channels)];
  return result;
}

std::string prescription_text(const Sin2GalleryEntry& view) {
  std::string text = plain_number(view.sphere_D.value_or(0.0));
  if (view.cylinder_D.value_or(0.0) != 0.0)
    text += " / " + plain_number(*view.cylinder_D) + " × " + plain_number(view.axis_deg.value_or(0.0));
  const Number distance = finite(view.distance_m);
  return text + ", target " + (distance ? plain_number(*distance) + " m" : "at infinity") + ", pupil " +
         plain_number(view.pupil_mm.value_or(0.0)) + " mm";
}

Html labels(const Sin2GalleryEntry& view, double y) {
  const double mid = y + 0.5 * gallery_side, field = 2.0 * view.half_side_arcmin.value_or(0.0);
  // A long title takes two lines, broken at its colon.
  const std::string& title = view.title;
  const std::size_t colon = title.find(": ");
  Html svg = svg_text(8.0, mid - 34.0, title.substr(0, colon), "start", 15);
  if (colon != std::string::npos) svg += svg_text(8.0, mid - 14.0, title.substr(colon + 2), "start", 13);
  return svg + svg_text(8.0, mid + 8.0, prescription_text(view), "start", 11, "#5c6670") +
         svg_text(8.0, mid + 26.0, "field " + plain_number(field, 3) + " arcmin", "start", 11, "#5c6670");
}

/// One row: all models on one scale, whose top is the densest pixel of the row.
Html row_svg(const Sin2GalleryEntry& view, double y, const std::filesystem::path& run_folder) {
  std::array<Image, columns.size()> pictures;
  float peak = 0.0f;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Sin2Spread* spread = of_model(view, columns[i].model);
    if (!spread || spread->file.empty()) continue;
    pictures[i] = one_channel(main_layer(run_folder / spread->file));
    peak = std::max(peak, *std::max_element(pictures[i].pixels.begin(), pictures[i].pixels.end()));
  }
  Html svg = labels(view, y);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double x = gallery_left + (gallery_side + gallery_gap) * static_cast<double>(i);
    if (pictures[i].pixels.empty() || !(peak > 0.0f)) {
      svg += svg_text(x + 0.5 * gallery_side, y + 0.5 * gallery_side, "undefined");
      continue;
    }
    svg += empty_element("image", {{"x", coordinate(x)},
                                   {"y", coordinate(y)},
                                   {"width", coordinate(gallery_side)},
                                   {"height", coordinate(gallery_side)},
                                   {"href", data_uri(sequential_false_colour(pictures[i], {peak, decades}))}}) +
           "\n"_html;
    const Number distance = of_model(view, columns[i].model)->total_variation;
    if (distance && i > 0) {
      svg += empty_element("rect", {{"x", coordinate(x)},
                                    {"y", coordinate(y + gallery_side - 22.0)},
                                    {"width", "76"},
                                    {"height", "22"},
                                    {"fill", "#000000"}}) +
             "\n"_html +
             svg_text(x + 8.0, y + gallery_side - 7.0, "TV " + plain_number(*distance, 2), "start", 12, "#ffffff");
    }
  }
  return svg;
}

}  // namespace

std::optional<Figure> sin2_gallery(const Sin2StudyFindings& found, const std::filesystem::path& run_folder) {
  if (found.gallery.empty()) return std::nullopt;
  Html body = white_ground();
  for (std::size_t i = 0; i < columns.size(); ++i)
    body += svg_text(gallery_left + (gallery_side + gallery_gap) * static_cast<double>(i) + 0.5 * gallery_side,
                     gallery_top - 14.0, columns[i].title, "middle", 14);
  double y = gallery_top;
  for (const Sin2GalleryEntry& view : found.gallery) {
    body += row_svg(view, y, run_folder);
    y += gallery_side + gallery_gap;
  }
  Figure figure;
  figure.id = "sin2_study_gallery";
  figure.section = "sin2_study";
  figure.title = "Point-spread functions, logarithmic";
  figure.caption =
      "Density of traced rays, three decades below the densest pixel of each row (black: less). TV: total variation "
      "distance "
      "from wavefront theory, 0 = the same, 1 = apart.";
  figure.svg = svg_document(static_cast<int>(std::lround(gallery_left + 4.0 * (gallery_side + gallery_gap))),
                            static_cast<int>(std::lround(y)), figure.title, body);
  return figure;
}

}  // namespace sturm
