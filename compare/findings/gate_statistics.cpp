#include "compare/findings/gate_statistics.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/findings/quantities.h"
#include "compare/gates/extreme_statistic.h"
#include "compare/studies/agreement/agreement_statistics.h"
#include "compare/studies/bench/statistics.h"
#include "compare/studies/lens/lens_study_statistics.h"
#include "compare/studies/samplings/sampling_statistics.h"
#include "compare/studies/sin2/statistics.h"
#include "io/json/stored.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double least_cylinder_D = 0.5;  // below it the two ray models are too close for their difference to be a test

void add_reference(const Json& report, Statistics& out) {
  const Number cases = number_at(report, "reference/cases");
  const auto worst_of = [&](std::initializer_list<const char*> names) {
    Extreme worst;
    if (cases && *cases >= 1.0)
      for (const char* name : names)
        worst.add(number_at(report, std::string("reference/max_relative_error/") + name), name);
    Statistic s = worst.result();
    s.cases = cases ? static_cast<std::uint64_t>(*cases) : 0;
    return s;
  };
  out["conoid_reference_max_relative_error"] = worst_of({"conoid_semi_axes", "conoid_covariance"});
  out["sin2_reference_max_relative_error"] = worst_of({"sin2_closed_form"});
}

/// The rays of one model in a case, or null.
const Json& rays_of(const Json& ellipse_case, const std::string& model) {
  static const Json none;
  for (const Json& rays : array_at(ellipse_case, "rays"))
    if (text_at(rays, "ray_model") == model) return rays;
  return none;
}

/// Frobenius distance of two covariances [xx, xy, yy] relative to the second.
Number relative_difference(const Json& of, const Json& from) {
  double difference = 0.0, norm = 0.0;
  for (const auto& [index, weight] : {std::pair{"0", 1.0}, {"1", 2.0}, {"2", 1.0}}) {
    const Number a = number_at(of, index), b = number_at(from, index);
    if (!a || !b) return std::nullopt;
    difference += weight * (*a - *b) * (*a - *b);
    norm += weight * *b * *b;
  }
  return norm > 0.0 ? Number(std::sqrt(difference / norm)) : std::nullopt;
}

Number quotient(const Number& a, const Number& b) {
  return a && b && *b > 0.0 ? Number(*a / *b) : std::nullopt;
}

void add_ellipses(const Json& report, Statistics& out) {
  Extreme matrix_z, matrix_relative, lens_z, lens_relative, sin2_z, sin2_relative;
  Extreme differs_z(Extreme::Of::Smallest), ratio_min(Extreme::Of::Smallest), ratio_max;
  for (const Json& c : array_at(report, "ellipses/cases")) {
    const std::string id = text_at(c, "id");
    const Number cylinder = number_at(c, "cylinder_D");
    const Json &matrix = rays_of(c, "power_matrix"), &sin2 = rays_of(c, "sin2_radial"), &lens = rays_of(c, "thin_lens");
    matrix_z.add(number_at(matrix, "against_conoid/z_max"), id);
    matrix_relative.add(number_at(matrix, "against_conoid/relative_frobenius"), id);
    sin2_z.add(number_at(sin2, "against_closed_form/z_max"), id);
    sin2_relative.add(number_at(sin2, "against_closed_form/relative_frobenius"), id);
    if (!cylinder || *cylinder == 0.0) {
      lens_z.add(number_at(lens, "against_conoid/z_max"), id);
      lens_relative.add(number_at(lens, "against_conoid/relative_frobenius"), id);
    }
    if (!cylinder || std::abs(*cylinder) >= least_cylinder_D) {
      const Number predicted =
          relative_difference(value_at(c, "sin2_closed_form/covariance_rad2"), value_at(c, "conoid/covariance_rad2"));
      const Number ratio = quotient(number_at(sin2, "against_conoid/relative_frobenius"), predicted);
      differs_z.add(number_at(sin2, "against_conoid/z_max"), id);
      ratio_min.add(ratio, id);
      ratio_max.add(ratio, id);
    }
  }
  out["matrix_vs_conoid_max_z"] = matrix_z.result();
  out["matrix_vs_conoid_max_relative"] = matrix_relative.result();
  out["thin_lens_vs_conoid_max_z"] = lens_z.result();
  out["thin_lens_vs_conoid_max_relative"] = lens_relative.result();
  out["sin2_vs_closed_form_max_z"] = sin2_z.result();
  out["sin2_vs_closed_form_max_relative"] = sin2_relative.result();
  out["sin2_vs_conoid_min_z"] = differs_z.result();
  out["sin2_vs_conoid_min_relative_difference_ratio"] = ratio_min.result();
  out["sin2_vs_conoid_max_relative_difference_ratio"] = ratio_max.result();
}

struct AxisDeviation {
  Number z, relative;
  bool resolved = false;  ///< the predicted axis is long enough for a relative error
};

constexpr double resolved_axis_px = 4.0;  // there the pixel grid's share of a semi-axis is below 1 %

/// Sheppard's correction of a hard-edged ellipse is exact up to the pixels on its rim. Against exact pixel areas
/// (ellipses of 1 … 12 px in all directions) it is wrong by up to 0.1 px²/width in a half-width, which is this.
double grid_allowance(double width, double pixel) {
  const double variance4 = 0.2 * pixel * pixel;
  return variance4 / (std::sqrt(width * width + variance4) + width);
}

/// Half-width 2√variance of the measured ellipse along the two **predicted** axes against the predicted semi-axes.
/// (Measured axes that are sorted by length are biased apart near a circle.)
std::array<AxisDeviation, 2> psf_deviations(const Json& psf) {
  const Number major = number_at(psf, "measured/semi_axes_arcmin/0"),
               minor = number_at(psf, "measured/semi_axes_arcmin/1");
  const Number se_major = number_at(psf, "measured/standard_error_arcmin/0"),
               se_minor = number_at(psf, "measured/standard_error_arcmin/1");
  const std::array<Number, 2> expected{number_at(psf, "predicted/semi_axes_arcmin/0"),
                                       number_at(psf, "predicted/semi_axes_arcmin/1")};
  const Number pixel = number_at(psf, "pixel_arcmin");
  if (!major || !minor || !se_major || !se_minor || !expected[0] || !expected[1] || !pixel) return {};
  const Number from = number_at(psf, "predicted/orientation_deg"), to = number_at(psf, "measured/orientation_deg");
  const SineCosine turn =
      sine_cosine_of_degrees(from && to ? *to - *from : 0.0);  // a circle has no angle and needs none
  std::array<AxisDeviation, 2> result;
  for (int i = 0; i < 2; ++i) {
    const double along = i == 0 ? turn.cosine : turn.sine, across = i == 0 ? turn.sine : turn.cosine;
    const double width = std::hypot(along * *major, across * *minor);
    // d(width) = (along² · major · d(major) + across² · minor · d(minor))/width; for a width of zero both axes are
    // zero.
    const double statistical =
        width > 0.0 ? std::hypot(along * along * *major * *se_major, across * across * *minor * *se_minor) / width
                    : std::hypot(along * *se_major, across * *se_minor);
    const double error = std::hypot(statistical, grid_allowance(*expected[i], *pixel)),
                 deviation = std::abs(width - *expected[i]);
    if (error > 0.0) result[i].z = deviation / error;
    result[i].resolved = *expected[i] >= resolved_axis_px * *pixel;
    if (result[i].resolved) result[i].relative = deviation / *expected[i];
  }
  return result;
}

/// Where a centroid is from its predicted place along one axis.
struct Displacement {
  double px, error_px;  ///< error_px > 0
};

/// The predicted place is the chief ray's: the first-order footprint of a pupil is centred on it. The spot lies in the
/// middle of an even number of pixels, and both are symmetric about it: the grid has no share in the centroid.
std::array<std::optional<Displacement>, 2> psf_displacements(const Json& psf) {
  std::array<std::optional<Displacement>, 2> result;
  const Number pixel = number_at(psf, "pixel_arcmin");
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string axis = std::to_string(i);
    const Number is = number_at(psf, "measured/centroid_arcmin/" + axis),
                 error = number_at(psf, "measured/centroid_standard_error_arcmin/" + axis);
    if (is && error && *error > 0.0 && pixel && *pixel > 0.0) result[i] = {*is / *pixel, *error / *pixel};
  }
  return result;
}

/// The displacement that all spots have in common, as if every picture had slipped on its pixel grid: their mean in
/// pixels, weighted with the inverse variances, over its standard error. Of n equally sharp spots it sees a slip √n
/// times as clearly as one of them.
class CommonDisplacement {
 public:
  void add(const std::optional<Displacement>& d) {
    if (!d) return;
    const double weight = 1.0 / (d->error_px * d->error_px);
    weights_ += weight;
    weighted_ += weight * d->px;
  }

  Number z() const { return weights_ > 0.0 ? Number(std::abs(weighted_) / std::sqrt(weights_)) : std::nullopt; }

 private:
  double weights_ = 0.0, weighted_ = 0.0;
};

void add_psfs(const Json& report, Statistics& out) {
  Extreme z, relative, centroid_z;
  std::array<CommonDisplacement, 2> common;
  for (const Json& psf : array_at(report, "psfs")) {
    if (text_at(psf, "ray_model") != "power_matrix") continue;
    const auto deviations = psf_deviations(psf);
    const auto displacements = psf_displacements(psf);
    for (std::size_t i = 0; i < 2; ++i) {
      const std::optional<Displacement>& d = displacements[i];
      centroid_z.add(d ? Number(std::abs(d->px) / d->error_px) : std::nullopt, text_at(psf, "id"));
      common[i].add(d);
      const std::string name = text_at(psf, "id") + (i == 0 ? ", major axis" : ", minor axis");
      z.add(deviations[i].z, name);
      // A short minor axis has no relative error by design; a PSF without numbers, or too small as a whole, shows in
      // its major axis.
      if (i == 0 || deviations[i].resolved) relative.add(deviations[i].relative, name);
    }
  }
  if (centroid_z.result().cases > 0)
    for (std::size_t i = 0; i < 2; ++i)
      centroid_z.add(common[i].z(), i == 0 ? "all spots together, x" : "all spots together, y");
  out["psf_matrix_axis_max_z"] = z.result();
  out["psf_matrix_axis_max_relative"] = relative.result();
  out["psf_matrix_centroid_max_z"] = centroid_z.result();
}

void add_images(const Json& report, Statistics& out) {
  Extreme lowest(Extreme::Of::Smallest), gain(Extreme::Of::Smallest), sin2_over_floor(Extreme::Of::Smallest),
      below_floor, over_floor;
  Extreme light, shift;
  for (const Json& image : array_at(report, "images")) {
    const std::string id = text_at(image, "id"), model = text_at(image, "ray_model");
    const Number rmse_over_floor =
        quotient(number_at(image, "metrics/rmse_linear"), number_at(image, "noise_floor/rmse_linear"));
    if (model == "sin2_radial") sin2_over_floor.add(rmse_over_floor, id);
    if (model != "power_matrix") continue;
    const Number ssim = number_at(image, "metrics/ssim_display/value"),
                 uncertainty = number_at(image, "metrics/ssim_display/uncertainty");
    const Number floor = number_at(image, "noise_floor/ssim_display");
    out["image_ssim_display/" + id] = {ssim, uncertainty, 1, id,
                                       degrees_of_metric(report, id, value_at(image, "metrics/ssim_display"))};
    lowest.add(ssim, id, uncertainty);
    over_floor.add(rmse_over_floor, id);
    const Number ratio = number_at(image, "metrics/light_ratio/value");
    light.add(ratio ? Number(std::abs(*ratio - 1.0)) : std::nullopt, id,
              number_at(image, "metrics/light_ratio/uncertainty"));
    const Number x = number_at(image, "metrics/shift_x_px/value"), y = number_at(image, "metrics/shift_y_px/value");
    shift.add(x && y ? Number(std::hypot(*x, *y)) : std::nullopt, id);
    below_floor.add(ssim && floor ? Number(*floor - *ssim) : std::nullopt, id, uncertainty);
    for (const Json& other : array_at(report, "images")) {
      if (text_at(other, "id") != id || text_at(other, "ray_model") != "sin2_radial") continue;
      const Number of_sin2 = number_at(other, "metrics/ssim_display/value");
      gain.add(ssim && of_sin2 ? Number(*ssim - *of_sin2) : std::nullopt, id);
    }
  }
  out["image_ssim_display_min"] = lowest.result();
  out["image_light_max_deviation"] = light.result();
  out["image_shift_max_px"] = shift.result();
  out["image_ssim_below_noise_floor_max"] = below_floor.result();
  out["image_ssim_gain_of_matrix_over_sin2_min"] = gain.result();
  out["image_matrix_rmse_over_noise_floor_max"] = over_floor.result();
  out["image_sin2_rmse_over_noise_floor_min"] = sin2_over_floor.result();
}

void add_mutants(const Json& report, Statistics& out) {
  Extreme least(Extreme::Of::Smallest);
  for (const Json& mutant : array_at(report, "must_fail")) {
    const std::string id = text_at(mutant, "id");
    const bool admits = boolean_at(mutant, "failed_as_it_must").value_or(false);
    const Number value = admits ? number_at(mutant, "value") : std::nullopt;
    out["must_fail/" + id] = {value, std::nullopt, 1, id};
    least.add(quotient(value, number_at(mutant, "bound")), id);
  }
  out["must_fail_min_value_over_bound"] = least.result();
}

void add_gate_power(const Json& report, Statistics& out) {
  Extreme fewest(Extreme::Of::Smallest);
  for (const Json& mutation : array_at(report, "gate_power/mutations"))
    fewest.add(static_cast<double>(array_at(mutation, "caught_by").size()), text_at(mutation, "id"));
  out["mutation_min_gates"] = fewest.result();
}

}  // namespace

Statistics statistics_of(const Json& report) {
  Statistics out;
  add_reference(report, out);
  add_ellipses(report, out);
  add_psfs(report, out);
  add_images(report, out);
  add_agreement_statistics(report, out);
  add_mutants(report, out);
  add_gate_power(report, out);
  add_lens_study(report, out);
  add_sampling_study(report, out);
  add_sin2_study(report, out);
  add_bench_statistics(report, out);
  return out;
}

}  // namespace sturm
