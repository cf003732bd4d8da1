#include "reports/sections/picture_tables.h"

#include "compare/findings/prediction_reasons.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"

namespace sturm {

namespace {

Html measured_cell(const Estimate& measured) {
  return measured_html(measured.value, measured.uncertainty);
}

Html counted(const std::optional<std::uint64_t>& count) {
  return count_html(count ? Number(static_cast<double>(*count)) : std::nullopt);
}

Number one_minus(const Number& value) {
  return value ? Number(1.0 - *value) : std::nullopt;
}

Html metric_html(const PictureFinding& picture, const std::string& name) {
  const PictureMetric metric = picture.prediction().metric(name);
  const Html html = metric.has_error ? measured_html(metric.value, metric.uncertainty) : number_html(metric.value, 3);
  const Number floor = picture.noise_floor.of(name);
  return floor ? html + small_html("floor "_html + number_html(floor, 3)) : html;
}

Html speed_up_html(const PictureFinding& picture) {
  const Number slow = picture.seconds_path_traced, fast = picture.prediction().seconds_of("total");
  return slow && fast && *fast > 0.0 ? "× "_html + number_html(*slow / *fast, 2) : absent_html();
}

Html predicted_seconds_html(const PredictionFinding& prediction) {
  const Number sharp = prediction.seconds_of("sharp_view"), spreading = prediction.seconds_of("spreading");
  Html html = number_html(prediction.seconds_of("total"), 3);
  if (sharp && spreading)
    html += small_html("sharp view "_html + number_html(sharp, 2)) +
            small_html("spreading "_html + number_html(spreading, 2));
  return html;
}

Html region_table(const PictureFinding& view) {
  HtmlTable table("By region", "metrics",
                  {{"Prediction"_html, false},
                   {"Region"_html, false},
                   {"Pixels"_html},
                   {"SSIM"_html},
                   {"RMSE"_html},
                   {"Noise of the prediction"_html},
                   {"Noise of the reference"_html},
                   {"Share of the squared error"_html}});
  for (const PredictionFinding& prediction : view.predictions)
    for (const PartErrors& part : prediction.parts)
      table.add_row({code_html(prediction.kind_name()), text_or_dash(part.name), counted(part.pixels),
                     measured_cell(part.ssim.value_or(Estimate{})), measured_cell(part.rmse),
                     number_html(part.prediction_noise, 2), number_html(part.reference_noise, 2),
                     number_html(part.share_of_squared_error, 2)});
  return table.html();
}

/// What the report finds of each prediction against its bars, with what is missing.
Html reasons(const PictureFinding& view) {
  Html items;
  for (const PredictionFinding& prediction : view.predictions) {
    Html sentences;
    for (const std::string& sentence : prediction_reasons(view, prediction)) sentences += " "_html + text(sentence);
    if (!sentences.empty()) items += element("li", code_html(prediction.kind_name()) + sentences);
  }
  return items.empty() ? Html() : element("ul", {{"class", "reasons"}}, items);
}

}  // namespace

Html picture_metrics_table(const std::vector<PictureFinding>& pictures) {
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
  for (const PictureFinding& picture : pictures)
    table.add_row({text_or_dash(picture.id), code_html(picture.model()), metric_html(picture, "ssim_display"),
                   metric_html(picture, "ssim_linear"), metric_html(picture, "psnr_display_dB"),
                   metric_html(picture, "rmse_linear"), metric_html(picture, "relative_mse"),
                   number_html(picture.seconds_path_traced, 3), predicted_seconds_html(picture.prediction()),
                   speed_up_html(picture)});
  return table.html();
}

Html prediction_table(const std::vector<PictureFinding>& pictures) {
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
  for (const PictureFinding& view : pictures)
    for (const PredictionFinding& prediction : view.predictions) {
      const PartErrors whole = prediction.whole();
      table.add_row({text_or_dash(view.id), code_html(prediction.kind_name()),
                     measured_cell(whole.ssim.value_or(Estimate{})) +
                         small_html("floor "_html + number_html(view.noise_floor.of("ssim_display"), 4)),
                     number_html(one_minus(prediction.similarity_loss.method), 4), measured_cell(whole.rmse),
                     number_html(prediction.seconds_of("total"), 3), number_html(prediction.cost_in_paths, 3),
                     number_html(prediction.samples_of_equal_error, 3), number_html(prediction.times_faster, 3)});
    }
  return table.html();
}

Html prediction_details(const PictureFinding& view) {
  return view.measures == PictureMeasures::Regions ? reasons(view) + region_table(view) : Html();
}

}  // namespace sturm
