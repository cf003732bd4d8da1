#include "compare/findings/quantities.h"

#include <string_view>

#include "io/files/formatted_text.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

using Quantities = std::map<std::string, Quantity>;
using Better = Quantity::Better;

/// Degrees of freedom of a scatter between `replicates`.
std::optional<double> degrees_of(std::optional<double> replicates) {
  return replicates && *replicates > 1.0 ? std::optional(*replicates - 1.0) : std::nullopt;
}

void add_ellipses(const Json& report, Quantities& out) {
  const auto degrees = degrees_of(number_at(report, "ellipses/conditions/replicates"));
  for (const Json& item : array_at(report, "ellipses/cases")) {
    const std::string name = "ellipse " + text_at(item, "id");
    for (const auto& [index, axis] : {std::pair("0", "major"), std::pair("1", "minor")})
      out[name + ", conoid: semi-" + axis + " axis [rad]"] = {
          .value = number_at(item, std::string("conoid/semi_axes_rad/") + index)};
    for (const Json& rays : array_at(item, "rays")) {
      const std::string model = text_at(rays, "ray_model");
      const Json& prediction = value_at(item, model == "sin2_radial" ? "sin2_closed_form" : "conoid");
      for (const auto& [index, component] : {std::pair("0", "xx"), std::pair("1", "xy"), std::pair("2", "yy")}) {
        const std::string at = index;
        out[name + ", " + model + ": covariance " + component + " [rad²]"] = {
            .value = number_at(rays, "covariance_rad2/" + at),
            .standard_error = number_at(rays, "covariance_standard_error_rad2/" + at),
            .degrees = degrees,
            .better = Better::Nearer,
            .target = number_at(prediction, "covariance_rad2/" + at)};
      }
    }
  }
}

void add_psfs(const Json& report, Quantities& out) {
  for (const Json& psf : array_at(report, "psfs"))
    for (const auto& [index, axis] : {std::pair("0", "major"), std::pair("1", "minor")}) {
      const std::string at = index;
      out["PSF " + text_at(psf, "id") + ", " + text_at(psf, "ray_model") + ": semi-" + axis + " axis [arcmin]"] = {
          .value = number_at(psf, "measured/semi_axes_arcmin/" + at),
          .standard_error = number_at(psf, "measured/standard_error_arcmin/" + at),
          .better = Better::Nearer,
          .target = number_at(psf, "predicted/semi_axes_arcmin/" + at)};
    }
}

/// What a metric of two equal pictures is, where neither less nor more is better.
std::optional<double> target_of(const std::string& metric) {
  if (metric == "light_ratio") return 1.0;
  if (metric == "shift_x_px" || metric == "shift_y_px") return 0.0;
  return std::nullopt;
}

/// As the report's experiment states them.
std::optional<double> replicates_of_image(const Json& report, const std::string& id) {
  for (const Json& image : array_at(report, "spec/images"))
    if (text_at(image, "id") == id) return number_at(image, "replicates");
  return std::nullopt;
}

void add_images(const Json& report, Quantities& out) {
  for (const Json& image : array_at(report, "images")) {
    const std::string id = text_at(image, "id"), name = "image " + id + ", " + text_at(image, "ray_model") + ": ";
    const Json& metrics = value_at(image, "metrics");
    if (!metrics.is_object()) continue;
    for (const auto& [key, metric] : metrics.items()) {
      const bool similarity = key.find("ssim") != std::string::npos || key.find("psnr") != std::string::npos;
      Quantity q{.value = number_at(metric, metric.is_object() ? "value" : ""),
                 .better = similarity ? Better::More : Better::Less};
      if (const std::optional<double> target = target_of(key)) q.better = Better::Nearer, q.target = target;
      if (metric.is_object()) {
        q.standard_error = number_at(metric, "uncertainty");
        q.degrees = degrees_of_metric(report, id, metric);
      }
      out[name + key] = q;
    }
    add_noise_floor(image, name, replicates_of_image(report, id), out);
  }
}

void add_reference(const Json& report, Quantities& out) {
  const Json& errors = value_at(report, "reference/max_relative_error");
  if (!errors.is_object()) return;
  for (const auto& [key, error] : errors.items())
    out["reference: relative error of " + key] = {.value = number_at(error, ""), .better = Better::Less};
}

void add_lens_study(const Json& report, Quantities& out) {
  for (const Json& view : array_at(report, "lens_study/views")) {
    std::string name = "lens study " + text_at(view, "lens");
    for (const char* key : {"eccentricity_deg", "direction_deg", "distance_m"}) {
      const auto number = number_at(view, key);
      name += "|" + (number ? plain_number(*number) : text_at(view, key));
    }
    for (const char* key : {"order", "relative_order", "limit_relative"})
      out[name + ": " + key] = {.value = number_at(view, key)};
  }
}

}  // namespace

void add_noise_floor(const Json& entry, const std::string& name, std::optional<double> replicates,
                     std::map<std::string, Quantity>& out) {
  const Json& floor = value_at(entry, "noise_floor");
  if (!floor.is_object()) return;
  for (const auto& [key, value] : floor.items())
    out[name + "noise floor of " + key] = {
        .value = number_at(value, ""),
        .standard_error = number_at(entry, "noise_floor_uncertainty/" + key),
        .degrees = replicates && *replicates > 3.0 ? std::optional(*replicates - 2.0) : std::nullopt,
        .better = key.starts_with("ssim") ? Better::More : Better::Less};
}

std::optional<double> degrees_of_metric(const Json& report, const std::string& id, const Json& metric) {
  if (const auto stated = number_at(metric, "degrees"); stated && *stated > 0.0) return stated;
  return degrees_of(replicates_of_image(report, id));
}

std::map<std::string, Quantity> quantities_of(const Json& report) {
  Quantities out;
  add_ellipses(report, out);
  add_psfs(report, out);
  add_images(report, out);
  add_reference(report, out);
  add_lens_study(report, out);
  add_study_quantities(report, out);
  return out;
}

}  // namespace sturm
