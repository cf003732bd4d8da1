#include <nlohmann/json.hpp>

#include "compare/studies/agreement/agreement_reasons.h"
#include "io/json/stored.h"
#include "reports/markup/markup.h"
#include "reports/markup/numbers.h"
#include "reports/sections/agreement_pictures.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

std::string measured_cell(const Json& value) {
  return measured_html(number_at(value, "value"), number_at(value, "uncertainty"));
}

std::optional<double> one_minus(const std::optional<double>& value) {
  return value ? std::optional(1.0 - *value) : std::nullopt;
}

std::string summary_table(const Json& entries) {
  HtmlTable table("Predictions against path tracing", "metrics",
                  {{"View", false},
                   {"Prediction", false},
                   {"SSIM"},
                   {"SSIM without noise"},
                   {"RMSE"},
                   {"Predicted [s]"},
                   {"Its time in paths per pixel"},
                   {"Paths per pixel of equal error"},
                   {"Times faster than path tracing to equal error"}});
  for (const Json& entry : entries)
    for (const Json& prediction : array_at(entry, "predictions")) {
      const Json& whole = value_at(prediction, "parts/0");
      table.add_row({text_html(text_at(entry, "id")), "<code>" + text_html(text_at(prediction, "kind")) + "</code>",
                     measured_cell(value_at(whole, "ssim_display")) + "<small>floor " +
                         number_html(number_at(entry, "noise_floor/ssim_display"), 4) + "</small>",
                     number_html(one_minus(number_at(prediction, "similarity_loss/method")), 4),
                     measured_cell(value_at(whole, "rmse_display")),
                     number_html(number_at(prediction, "seconds/total"), 3),
                     number_html(number_at(prediction, "cost_in_paths"), 3),
                     number_html(number_at(prediction, "samples_of_equal_error"), 3),
                     number_html(number_at(prediction, "times_faster"), 3)});
    }
  return table.html();
}

std::string region_table(const Json& entry) {
  HtmlTable table("By region", "metrics",
                  {{"Prediction", false},
                   {"Region", false},
                   {"Pixels"},
                   {"SSIM"},
                   {"RMSE"},
                   {"Noise of the prediction"},
                   {"Noise of the reference"},
                   {"Share of the squared error"}});
  for (const Json& prediction : array_at(entry, "predictions"))
    for (const Json& part : array_at(prediction, "parts"))
      table.add_row({"<code>" + text_html(text_at(prediction, "kind")) + "</code>", text_html(text_at(part, "name")),
                     count_html(number_at(part, "pixels")), measured_cell(value_at(part, "ssim_display")),
                     measured_cell(value_at(part, "rmse_display")),
                     number_html(number_at(part, "prediction_noise_display"), 2),
                     number_html(number_at(part, "noise_display"), 2),
                     number_html(number_at(part, "share_of_squared_error"), 2)});
  return table.html();
}

/// What the report finds of each prediction against its bars, with what is missing.
std::string reasons(const Json& entry) {
  std::string items;
  for (const Json& prediction : array_at(entry, "predictions")) {
    std::string sentences;
    for (const std::string& sentence : agreement_reasons(entry, prediction)) sentences += " " + escaped(sentence);
    if (!sentences.empty())
      items += element("li", "", "<code>" + text_html(text_at(prediction, "kind")) + "</code>" + sentences);
  }
  return items.empty() ? "" : element("ul", "class=\"reasons\"", items);
}

}  // namespace

std::string agreement_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  const Json& entries = array_at(report, "agreement");
  if (entries.empty()) return "";
  std::string html = element("h2", "", "Predicted pictures") +
                     element("p", "",
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
                             "pictures that are shown, the noise of both included.") +
                     summary_table(entries);
  const std::vector<std::string> pictures = agreement_pictures(entries, run_folder, payload);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Json& entry = entries[i];
    const std::string note = text_at(entry, "note");
    html += element(
        "article", "",
        element("h3", "",
                text_html(text_at(entry, "id")) + " <small>" + text_html(text_at(entry, "scene")) + " · gaze " +
                    text_html(text_at(entry, "gaze")) + (note.empty() ? "" : " · " + text_html(note)) + "</small>") +
            pictures[i] + reasons(entry) + region_table(entry));
  }
  return element("section", "id=\"agreement\"", html);
}

}  // namespace sturm
