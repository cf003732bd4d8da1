#include <nlohmann/json.hpp>

#include "compare/studies/agreement/agreement_reasons.h"
#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/agreement_pictures.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Html measured_cell(const Json& value) {
  return measured_html(number_at(value, "value"), number_at(value, "uncertainty"));
}

std::optional<double> one_minus(const std::optional<double>& value) {
  return value ? std::optional(1.0 - *value) : std::nullopt;
}

Html summary_table(const Json& entries) {
  HtmlTable table("Predictions against path tracing", "metrics",
                  {{"View"_html, false},
                   {"Prediction"_html, false},
                   {"SSIM"_html},
                   {"SSIM without noise"_html},
                   {"RMSE"_html},
                   {"Predicted [s]"_html},
                   {"Its time in paths per pixel"_html},
                   {"Paths per pixel of equal error"_html},
                   {"Times faster than path tracing to equal error"_html}});
  for (const Json& entry : entries)
    for (const Json& prediction : array_at(entry, "predictions")) {
      const Json& whole = value_at(prediction, "parts/0");
      table.add_row({text_or_dash(text_at(entry, "id")), code_html(text_at(prediction, "kind")),
                     measured_cell(value_at(whole, "ssim_display")) +
                         small_html("floor "_html + number_html(number_at(entry, "noise_floor/ssim_display"), 4)),
                     number_html(one_minus(number_at(prediction, "similarity_loss/method")), 4),
                     measured_cell(value_at(whole, "rmse_display")),
                     number_html(number_at(prediction, "seconds/total"), 3),
                     number_html(number_at(prediction, "cost_in_paths"), 3),
                     number_html(number_at(prediction, "samples_of_equal_error"), 3),
                     number_html(number_at(prediction, "times_faster"), 3)});
    }
  return table.html();
}

Html region_table(const Json& entry) {
  HtmlTable table("By region", "metrics",
                  {{"Prediction"_html, false},
                   {"Region"_html, false},
                   {"Pixels"_html},
                   {"SSIM"_html},
                   {"RMSE"_html},
                   {"Noise of the prediction"_html},
                   {"Noise of the reference"_html},
                   {"Share of the squared error"_html}});
  for (const Json& prediction : array_at(entry, "predictions"))
    for (const Json& part : array_at(prediction, "parts"))
      table.add_row({code_html(text_at(prediction, "kind")), text_or_dash(text_at(part, "name")),
                     count_html(number_at(part, "pixels")), measured_cell(value_at(part, "ssim_display")),
                     measured_cell(value_at(part, "rmse_display")),
                     number_html(number_at(part, "prediction_noise_display"), 2),
                     number_html(number_at(part, "noise_display"), 2),
                     number_html(number_at(part, "share_of_squared_error"), 2)});
  return table.html();
}

/// What the report finds of each prediction against its bars, with what is missing.
Html reasons(const Json& entry) {
  Html items;
  for (const Json& prediction : array_at(entry, "predictions")) {
    Html sentences;
    for (const std::string& sentence : agreement_reasons(entry, prediction)) sentences += " "_html + text(sentence);
    if (!sentences.empty()) items += element("li", code_html(text_at(prediction, "kind")) + sentences);
  }
  return items.empty() ? Html() : element("ul", {{"class", "reasons"}}, items);
}

}  // namespace

Html agreement_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  const Json& entries = array_at(report, "agreement");
  if (entries.empty()) return {};
  Html html = element("h2", "Predicted pictures"_html) +
              element("p",
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
                      "pictures that are shown, the noise of both included."_html) +
              summary_table(entries);
  const std::vector<Html> pictures = agreement_pictures(entries, run_folder, payload);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Json& entry = entries[i];
    const std::string note = text_at(entry, "note");
    Html conditions = text_or_dash(text_at(entry, "scene")) + " · gaze "_html + text_or_dash(text_at(entry, "gaze"));
    if (!note.empty()) conditions += " · "_html + text(note);
    html += element("article", element("h3", text_or_dash(text_at(entry, "id")) + " "_html + small_html(conditions)) +
                                   pictures[i] + reasons(entry) + region_table(entry));
  }
  return element("section", {{"id", "agreement"}}, html);
}

}  // namespace sturm
