#include "reports/markup/pictures.h"

#include <utility>

#include "compare/findings/picture_json.h"
#include "io/files/formatted_text.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/command.h"
#include "reports/sections/picture_blocks.h"
#include "reports/sections/picture_tables.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Html about_metrics() {
  return element(
      "p",
      "The same view, path traced through the eye and predicted from one sharp view. <i>Floor</i> is the same "
      "metric between the "
      "two halves of the path-traced replicates, each with half of the samples: the path tracer against its "
      "own noise. Display "
      "means sRGB, clamped to 0 … 1."_html);
}

Html about_regions() {
  return element("p",
                 "Each prediction is one picture; it is compared in display space (sRGB, clamped to 0 … 1) "
                 "with the mean of all path-traced "
                 "replicates, whose noise is taken off the error. <i>SSIM without noise</i>: what is left "
                 "when the noise of the reference and "
                 "that of the prediction are extrapolated away, i.e. the method's own. <i>Equal error</i>: "
                 "so many paths per pixel give path "
                 "tracing the same mean squared error; how its error and its time depend on their number "
                 "was measured with an eighth of them. "
                 "Asked for are an SSIM of 0.98 and 20 times the speed. Regions, which may overlap: blur "
                 "of at most one pixel, blurred, within "
                 "reach of an edge of depth, display white, surfaces whose colour changes with the "
                 "direction, and within reach of a lamp's "
                 "rim. In the sentences each pixel counts once: lamp rims, then specular, then edges, then "
                 "the rest. Maps below are of the "
                 "pictures that are shown, the noise of both included."_html);
}

/// The scale of the differences. A page can hold one: its gradient has an id.
Html error_scale(double limit) {
  const std::string end = plain_number(limit), half = plain_number(0.5 * limit);
  return colour_bar_svg(ColourMap::Diverging,
                        {{0.0, "−" + end}, {0.25, "−" + half}, {0.5, "0"}, {0.75, half}, {1.0, end}},
                        "Predicted − path traced, luma in display space (one scale for all)");
}

Html conditions_of(const PictureFinding& picture, int still_factor) {
  Html conditions = text_or_dash(picture.scene);
  if (!picture.prescription.empty()) conditions += " · "_html + text(picture.prescription);
  if (!picture.gaze.empty()) conditions += " · gaze "_html + text(picture.gaze);
  const auto& samples = picture.samples_per_pixel;
  conditions += " · pupil "_html + exact_html(picture.pupil_mm) + " mm · "_html +
                count_html(samples ? Number(static_cast<double>(*samples)) : std::nullopt) + " samples per pixel"_html;
  if (!picture.note.empty()) conditions += " · "_html + text(picture.note);
  if (still_factor > 1) conditions += " · shown at 1/"_html + text(std::to_string(still_factor)) + " of its size"_html;
  return conditions;
}

Html article(const PictureFinding& picture, const PictureBlock& block) {
  const Html heading = text_or_dash(picture.id) + " · "_html + code_html(picture.model()) + " "_html +
                       small_html(conditions_of(picture, block.still_factor));
  return element("article", element("h3", heading) + block.html + prediction_details(picture));
}

}  // namespace

/// Pictures measured by metrics, and pictures measured by region, each under the id of its list in the report.
Html picture_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  const std::vector<PictureFinding> pictures = picture_findings(report);
  const PictureBlocks shown = picture_blocks(pictures, run_folder, payload);
  Html scale = error_scale(shown.error_limit);
  const auto section_of = [&](PictureMeasures measures, const Html& heading, const Html& about,
                              Html (*table)(const std::vector<PictureFinding>&)) {
    std::vector<PictureFinding> own;
    Html articles;
    for (std::size_t i = 0; i < pictures.size(); ++i)
      if (pictures[i].measures == measures) {
        own.push_back(pictures[i]);
        articles += article(pictures[i], shown.blocks[i]);
      }
    if (own.empty()) return Html();
    const Html html = element("h2", heading) + about + table(own) + std::exchange(scale, {}) + articles;
    return element("section", {{"id", list_name(measures)}}, html + made_by(report));
  };
  const Html metrics = section_of(PictureMeasures::Metrics, "Images"_html, about_metrics(), picture_metrics_table);
  const Html regions =
      section_of(PictureMeasures::Regions, "Predicted pictures"_html, about_regions(), prediction_table);
  if (metrics.empty() && regions.empty()) return {};
  return element("div", {{"id", "pictures"}}, metrics + regions);
}

}  // namespace sturm
