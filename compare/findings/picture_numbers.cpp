#include "compare/findings/picture_numbers.h"

#include <cmath>

#include "compare/findings/measured.h"
#include "compare/findings/picture_json.h"

namespace sturm {

namespace {

constexpr const char* similarity = "SSIM in display space";
constexpr const char* below_floor = "SSIM of two halves of the samples, less that of the prediction";
constexpr const char* gain = "SSIM in display space, less that with sin2_radial";
constexpr const char* over_floor = "RMSE ÷ noise floor";
constexpr const char* light = "deviation of the light from 1";
constexpr const char* shift = "displacement [px]";
constexpr const char* times_faster = "times faster";

/// What a metric of two equal pictures is, where neither less nor more is better.
Number target_of(const std::string& metric) {
  if (metric == "light_ratio") return 1.0;
  if (metric == "shift_x_px" || metric == "shift_y_px") return 0.0;
  return std::nullopt;
}

Number replicates_of(const PictureFinding& picture) {
  return picture.replicates ? Number(static_cast<double>(*picture.replicates)) : std::nullopt;
}

/// Degrees of freedom of the standard error of a metric: those that it states, else the replicates less one. None where
/// the report does not say.
Number degrees_of_metric(const PictureFinding& picture, const PictureMetric& metric) {
  return metric.degrees && *metric.degrees > 0.0 ? metric.degrees : degrees_of(replicates_of(picture));
}

/// A row of the table of cases: an error against what noise alone makes of it.
Measurement row_of(const Measurement& about, const Number& error, const Number& floor) {
  Measurement row = about;
  row.value = quotient(error, floor);
  row.listed_as = !row.value ? CaseStatus::NoResult : *row.value > 1.0 ? CaseStatus::Differs : CaseStatus::Agrees;
  return row;
}

/// The noise floors as numbers between runs; `name` ends with ": ". Each half of the replicates has one degree of
/// freedom less.
void add_noise_floor(const PictureFinding& picture, const std::string& name, const Measurement& about,
                     Measurements& out) {
  const Number replicates = replicates_of(picture);
  for (const auto& [key, value] : picture.noise_floor.metrics) {
    const auto& errors = picture.noise_floor.uncertainties;
    const auto error = errors.find(key);
    Measurement m = about;
    m.quantity = "noise floor of " + key;
    m.value = value;
    m.standard_error = error != errors.end() ? error->second : std::nullopt;
    m.degrees = replicates && *replicates > 3.0 ? Number(*replicates - 2.0) : std::nullopt;
    m.better = key.starts_with("ssim") ? Better::More : Better::Less;
    m.run_name = name + m.quantity;
    out.push_back(std::move(m));
  }
}

/// What gates judge of metrics: the picture by wavefront theory.
void add_judged(const std::vector<PictureFinding>& pictures, const PictureFinding& picture, Measurements& out) {
  const auto add = [&](const char* quantity, const Number& value, const Number& error = std::nullopt) {
    out.push_back({.section = "images",
                   .subject = picture.id,
                   .model = "power_matrix",
                   .quantity = quantity,
                   .value = value,
                   .standard_error = error});
  };
  const PredictionFinding prediction = picture.prediction();
  const PictureMetric ssim = prediction.metric("ssim_display"), ratio = prediction.metric("light_ratio");
  const Number floor = picture.noise_floor.of("ssim_display");
  add(similarity, ssim.value, ssim.uncertainty);
  out.back().degrees = degrees_of_metric(picture, ssim);
  out.back().statistic = "image_ssim_display/" + picture.id;
  add(light, ratio.value ? Number(std::abs(*ratio.value - 1.0)) : std::nullopt, ratio.uncertainty);
  const Number x = prediction.metric("shift_x_px").value, y = prediction.metric("shift_y_px").value;
  add(shift, x && y ? Number(std::hypot(*x, *y)) : std::nullopt);
  add(below_floor, ssim.value && floor ? Number(*floor - *ssim.value) : std::nullopt, ssim.uncertainty);
  for (const PictureFinding& other : pictures) {
    if (other.measures != picture.measures || other.id != picture.id || other.ray_model != RayModel::sin2_radial)
      continue;
    const Number of_sin2 = other.prediction().metric("ssim_display").value;
    add(gain, ssim.value && of_sin2 ? Number(*ssim.value - *of_sin2) : std::nullopt);
  }
}

/// What another run of the same experiment has, too.
void add_compared(const PictureFinding& picture, Measurements& out) {
  const std::string name = "image " + picture.id + ", " + picture.model() + ": ";
  for (const auto& [key, metric] : picture.prediction().metrics) {
    const bool similar = key.find("ssim") != std::string::npos || key.find("psnr") != std::string::npos;
    Measurement m{.section = "images",
                  .subject = picture.id,
                  .model = picture.model(),
                  .quantity = key,
                  .value = metric.value,
                  .better = similar ? Better::More : Better::Less,
                  .run_name = name + key};
    if (const Number target = target_of(key)) {
      m.better = Better::Nearer;
      m.target = target;
    }
    if (metric.has_error) {
      m.standard_error = metric.uncertainty;
      m.degrees = degrees_of_metric(picture, metric);
    }
    out.push_back(std::move(m));
  }
  add_noise_floor(picture, name, {.section = "images", .subject = picture.id, .model = picture.model(), .quantity = ""},
                  out);
}

void add_metrics(const std::vector<PictureFinding>& pictures, const PictureFinding& picture, Measurements& out) {
  out.push_back(row_of({.section = "images", .subject = picture.id, .model = picture.model(), .quantity = over_floor},
                       picture.prediction().metric("rmse_linear").value, picture.noise_floor.of("rmse_linear")));
  add_compared(picture, out);
  if (picture.ray_model == RayModel::power_matrix) add_judged(pictures, picture, out);
}

/// What gates judge of a prediction: the whole picture.
void add_judged(const PredictionFinding& prediction, const std::string& id, Measurements& out) {
  const std::string kind = prediction.kind_name();
  const auto add = [&](const char* quantity, const char* statistic, const Number& value, const Number& error) {
    out.push_back({.section = "agreement",
                   .subject = id,
                   .model = kind,
                   .quantity = quantity,
                   .value = value,
                   .standard_error = error,
                   .statistic = std::string(statistic) + "/" + id + "/" + kind});
  };
  const Estimate ssim = prediction.whole().ssim.value_or(Estimate{});
  const Number lost = prediction.similarity_loss.method;
  add(similarity, "agreement_ssim_display", ssim.value, ssim.uncertainty);
  add("SSIM in display space without noise", "agreement_ssim_without_noise", lost ? Number(1.0 - *lost) : std::nullopt,
      ssim.uncertainty);
  add(times_faster, "agreement_times_faster", prediction.times_faster, std::nullopt);
  // Of the times nothing says how far they scatter from run to run. There is none where the error is below the
  // reference's noise.
  out.back().better = Better::More;
  out.back().may_vanish = true;
  out.back().run_name = "prediction " + id + ", " + kind + ": times faster";
}

/// What another run of the same experiment has of a prediction, too: the parts of the picture.
void add_compared(const PredictionFinding& prediction, const std::string& id, const Number& degrees,
                  Measurements& out) {
  const std::string kind = prediction.kind_name();
  for (const PartErrors& part : prediction.parts) {
    const auto add = [&](const Estimate& measured, const char* title, Better better) {
      if (measured.value)
        out.push_back({.section = "agreement",
                       .subject = id,
                       .model = kind,
                       .quantity = part.name + ", " + title,
                       .value = measured.value,
                       .standard_error = measured.uncertainty,
                       .degrees = degrees,
                       .better = better,
                       .run_name = "prediction " + id + ", " + kind + ", " + part.name + ": " + title});
    };
    add(part.ssim.value_or(Estimate{}), "SSIM", Better::More);
    // Not its root: near zero that is neither unbiased nor has it an error that says much.
    add(part.mean_square, "mean square error", Better::Less);
  }
}

void add_regions(const PictureFinding& picture, Measurements& out) {
  const std::string& id = picture.id;
  add_noise_floor(picture, "prediction " + id + ": ",
                  {.section = "agreement", .subject = id, .model = "", .quantity = ""}, out);
  for (const PredictionFinding& prediction : picture.predictions) {
    add_judged(prediction, id, out);
    add_compared(prediction, id, degrees_of(replicates_of(picture)), out);
    out.push_back(row_of({.section = "agreement",
                          .subject = id,
                          .model = prediction.kind_name(),
                          .quantity = "RMSE in display space ÷ noise floor"},
                         prediction.whole().rmse.value, picture.noise_floor.of("rmse_display")));
  }
}

}  // namespace

void measure_pictures(const Json& report, Measurements& out) {
  const std::vector<PictureFinding> pictures = picture_findings(report);
  for (const PictureFinding& picture : pictures)
    if (picture.measures == PictureMeasures::Metrics)
      add_metrics(pictures, picture, out);
    else
      add_regions(picture, out);
}

std::span<const StatisticRule> picture_rules() {
  using Of = Extreme::Of;
  using Per = StatisticRule::Per;
  static constexpr StatisticRule rules[] = {
      {"image_ssim_display_min", "images", similarity, "power_matrix", Of::Smallest, true},
      {"image_light_max_deviation", "images", light, "power_matrix", Of::Largest, true},
      {"image_shift_max_px", "images", shift, "power_matrix"},
      {"image_ssim_below_noise_floor_max", "images", below_floor, "power_matrix", Of::Largest, true},
      {"image_ssim_gain_of_matrix_over_sin2_min", "images", gain, "power_matrix", Of::Smallest},
      {"image_matrix_rmse_over_noise_floor_max", "images", over_floor, "power_matrix"},
      {"image_sin2_rmse_over_noise_floor_min", "images", over_floor, "sin2_radial", Of::Smallest},
      {"agreement_ssim_display_min", "agreement", similarity, nullptr, Of::Smallest, true, Per::Model},
      {"agreement_times_faster_min", "agreement", times_faster, nullptr, Of::Smallest, false, Per::Model},
  };
  return rules;
}

}  // namespace sturm
