#include "compare/findings/psfs.h"

#include <array>
#include <cmath>

#include "compare/findings/measured.h"
#include "io/json/stored.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr const char* axis_z = "deviation of a semi-axis, in standard errors";
constexpr const char* axis_relative = "relative deviation of a semi-axis of at least 4 px";
constexpr const char* centroid_z = "displacement of the centroid, in standard errors";

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

void add(const std::string& subject, const char* quantity, const Number& value, Measurements& out) {
  out.push_back({.section = "psfs", .subject = subject, .model = "power_matrix", .quantity = quantity, .value = value});
}

/// What gates judge: rays by wavefront theory.
void add_judged(const Json& report, Measurements& out) {
  std::array<CommonDisplacement, 2> common;
  bool any = false;
  for (const Json& psf : array_at(report, "psfs")) {
    if (text_at(psf, "ray_model") != "power_matrix") continue;
    any = true;
    const std::string id = text_at(psf, "id");
    const auto deviations = psf_deviations(psf);
    const auto displacements = psf_displacements(psf);
    for (std::size_t i = 0; i < 2; ++i) {
      const std::optional<Displacement>& d = displacements[i];
      add(id, centroid_z, d ? Number(std::abs(d->px) / d->error_px) : std::nullopt, out);
      common[i].add(d);
      const std::string name = id + (i == 0 ? ", major axis" : ", minor axis");
      add(name, axis_z, deviations[i].z, out);
      // A short minor axis has no relative error by design; a PSF without numbers, or too small as a whole, shows in
      // its major axis.
      if (i == 0 || deviations[i].resolved) add(name, axis_relative, deviations[i].relative, out);
    }
  }
  for (std::size_t i = 0; any && i < 2; ++i)
    add(i == 0 ? "all spots together, x" : "all spots together, y", centroid_z, common[i].z(), out);
}

/// What another run of the same experiment has, too.
void add_compared(const Json& psf, Measurements& out) {
  const std::string id = text_at(psf, "id"), model = text_at(psf, "ray_model");
  for (const auto& [index, axis] : {std::pair("0", "major"), std::pair("1", "minor")}) {
    const std::string at = index, quantity = std::string("semi-") + axis + " axis [arcmin]";
    out.push_back({.section = "psfs",
                   .subject = id,
                   .model = model,
                   .quantity = quantity,
                   .value = number_at(psf, "measured/semi_axes_arcmin/" + at),
                   .standard_error = number_at(psf, "measured/standard_error_arcmin/" + at),
                   .better = Better::Nearer,
                   .target = number_at(psf, "predicted/semi_axes_arcmin/" + at),
                   .run_name = "PSF " + id + ", " + model + ": " + quantity});
  }
}

void add_row(const Json& psf, Measurements& out) {
  const auto predicted = number_at(psf, "predicted/semi_axes_arcmin/0"),
             measured = number_at(psf, "measured/semi_axes_arcmin/0");
  std::optional<double> relative;
  if (predicted && measured && *predicted > 0.0) relative = std::abs(*measured / *predicted - 1.0);
  out.push_back({.section = "psfs",
                 .subject = text_at(psf, "id"),
                 .model = text_at(psf, "ray_model"),
                 .quantity = "relative difference of major axes, from the conoid",
                 .value = relative,
                 .listed_as = relative ? CaseStatus::Measured : CaseStatus::NoResult});
}

}  // namespace

void measure_psfs(const Json& report, Measurements& out) {
  add_judged(report, out);
  for (const Json& psf : array_at(report, "psfs")) {
    add_compared(psf, out);
    add_row(psf, out);
  }
}

std::span<const StatisticRule> psf_rules() {
  static constexpr StatisticRule rules[] = {
      {"psf_matrix_axis_max_z", "psfs", axis_z, "power_matrix"},
      {"psf_matrix_axis_max_relative", "psfs", axis_relative, "power_matrix"},
      {"psf_matrix_centroid_max_z", "psfs", centroid_z, "power_matrix"},
  };
  return rules;
}

}  // namespace sturm
