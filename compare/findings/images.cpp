#include "compare/findings/images.h"

#include <cmath>

#include "compare/findings/measured.h"
#include "compare/findings/noise_floor.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

constexpr const char* similarity = "SSIM in display space";
constexpr const char* below_floor = "SSIM of two halves of the samples, less that of the prediction";
constexpr const char* gain = "SSIM in display space, less that with sin2_radial";
constexpr const char* over_floor = "RMSE ÷ noise floor";
constexpr const char* light = "deviation of the light from 1";
constexpr const char* shift = "displacement [px]";

/// What a metric of two equal pictures is, where neither less nor more is better.
Number target_of(const std::string& metric) {
  if (metric == "light_ratio") return 1.0;
  if (metric == "shift_x_px" || metric == "shift_y_px") return 0.0;
  return std::nullopt;
}

/// As the report's experiment states them.
Number replicates_of_image(const Json& report, const std::string& id) {
  for (const Json& image : array_at(report, "spec/images"))
    if (text_at(image, "id") == id) return number_at(image, "replicates");
  return std::nullopt;
}

/// Degrees of freedom of the standard error of one metric of image `id`: those that it states, else the image's
/// replicates less one. None where the report does not say.
Number degrees_of_metric(const Json& report, const std::string& id, const Json& metric) {
  if (const auto stated = number_at(metric, "degrees"); stated && *stated > 0.0) return stated;
  return degrees_of(replicates_of_image(report, id));
}

/// What gates judge: the picture by wavefront theory.
void add_judged(const Json& report, const Json& image, Measurements& out) {
  const std::string id = text_at(image, "id");
  const auto add = [&](const char* quantity, const Number& value, const Number& error = std::nullopt) {
    out.push_back({.section = "images",
                   .subject = id,
                   .model = "power_matrix",
                   .quantity = quantity,
                   .value = value,
                   .standard_error = error});
  };
  const Number ssim = number_at(image, "metrics/ssim_display/value"),
               uncertainty = number_at(image, "metrics/ssim_display/uncertainty");
  const Number floor = number_at(image, "noise_floor/ssim_display");
  add(similarity, ssim, uncertainty);
  out.back().degrees = degrees_of_metric(report, id, value_at(image, "metrics/ssim_display"));
  out.back().statistic = "image_ssim_display/" + id;
  const Number ratio = number_at(image, "metrics/light_ratio/value");
  add(light, ratio ? Number(std::abs(*ratio - 1.0)) : std::nullopt,
      number_at(image, "metrics/light_ratio/uncertainty"));
  const Number x = number_at(image, "metrics/shift_x_px/value"), y = number_at(image, "metrics/shift_y_px/value");
  add(shift, x && y ? Number(std::hypot(*x, *y)) : std::nullopt);
  add(below_floor, ssim && floor ? Number(*floor - *ssim) : std::nullopt, uncertainty);
  for (const Json& other : array_at(report, "images")) {
    if (text_at(other, "id") != id || text_at(other, "ray_model") != "sin2_radial") continue;
    const Number of_sin2 = number_at(other, "metrics/ssim_display/value");
    add(gain, ssim && of_sin2 ? Number(*ssim - *of_sin2) : std::nullopt);
  }
}

/// What another run of the same experiment has, too.
void add_compared(const Json& report, const Json& image, Measurements& out) {
  const std::string id = text_at(image, "id"), model = text_at(image, "ray_model");
  const std::string name = "image " + id + ", " + model + ": ";
  const Json& metrics = value_at(image, "metrics");
  if (!metrics.is_object()) return;
  for (const auto& [key, metric] : metrics.items()) {
    const bool similar = key.find("ssim") != std::string::npos || key.find("psnr") != std::string::npos;
    Measurement m{.section = "images",
                  .subject = id,
                  .model = model,
                  .quantity = key,
                  .value = number_at(metric, metric.is_object() ? "value" : ""),
                  .better = similar ? Better::More : Better::Less,
                  .run_name = name + key};
    if (const Number target = target_of(key)) {
      m.better = Better::Nearer;
      m.target = target;
    }
    if (metric.is_object()) {
      m.standard_error = number_at(metric, "uncertainty");
      m.degrees = degrees_of_metric(report, id, metric);
    }
    out.push_back(std::move(m));
  }
  add_noise_floor(image, name, replicates_of_image(report, id), {.section = "images", .subject = id, .model = model},
                  out);
}

/// A row of the table of cases, which gates judge, too.
void add_row(const Json& image, Measurements& out) {
  const Number ratio = quotient(number_at(image, "metrics/rmse_linear"), number_at(image, "noise_floor/rmse_linear"));
  out.push_back({.section = "images",
                 .subject = text_at(image, "id"),
                 .model = text_at(image, "ray_model"),
                 .quantity = over_floor,
                 .value = ratio,
                 .listed_as = !ratio         ? CaseStatus::NoResult
                              : *ratio > 1.0 ? CaseStatus::Differs
                                             : CaseStatus::Agrees});
}

}  // namespace

void measure_images(const Json& report, Measurements& out) {
  for (const Json& image : array_at(report, "images")) {
    add_row(image, out);
    add_compared(report, image, out);
    if (text_at(image, "ray_model") == "power_matrix") add_judged(report, image, out);
  }
}

std::span<const StatisticRule> image_rules() {
  using Of = Extreme::Of;
  static constexpr StatisticRule rules[] = {
      {"image_ssim_display_min", "images", similarity, "power_matrix", Of::Smallest, true},
      {"image_light_max_deviation", "images", light, "power_matrix", Of::Largest, true},
      {"image_shift_max_px", "images", shift, "power_matrix"},
      {"image_ssim_below_noise_floor_max", "images", below_floor, "power_matrix", Of::Largest, true},
      {"image_ssim_gain_of_matrix_over_sin2_min", "images", gain, "power_matrix", Of::Smallest},
      {"image_matrix_rmse_over_noise_floor_max", "images", over_floor, "power_matrix"},
      {"image_sin2_rmse_over_noise_floor_min", "images", over_floor, "sin2_radial", Of::Smallest},
  };
  return rules;
}

}  // namespace sturm
