#include "compare/findings/psf_numbers.h"

#include <array>
#include <cmath>

#include "compare/findings/measured.h"
#include "compare/findings/psfs.h"
#include "io/json/stored_values.h"
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
std::array<AxisDeviation, 2> psf_deviations(const PsfFinding& psf) {
  if (!psf.measured || !psf.measured->ellipse || !psf.measured->standard_error_arcmin) return {};
  if (!psf.predicted || !psf.pixel_arcmin) return {};
  const double major = psf.measured->ellipse->semi_major, minor = psf.measured->ellipse->semi_minor;
  const double se_major = psf.measured->standard_error_arcmin->x(), se_minor = psf.measured->standard_error_arcmin->y();
  const std::array expected{psf.predicted->semi_major, psf.predicted->semi_minor};
  const double pixel = *psf.pixel_arcmin;
  const Number from = psf.predicted->orientation_deg, to = psf.measured->ellipse->orientation_deg;
  const SineCosine turn =
      sine_cosine_of_degrees(from && to ? *to - *from : 0.0);  // a circle has no angle and needs none
  std::array<AxisDeviation, 2> result;
  for (int i = 0; i < 2; ++i) {
    const double along = i == 0 ? turn.cosine : turn.sine, across = i == 0 ? turn.sine : turn.cosine;
    const double width = std::hypot(along * major, across * minor);
    // d(width) = (along² · major · d(major) + across² · minor · d(minor))/width; for a width of zero both axes are
    // zero.
    const double statistical =
        width > 0.0 ? std::hypot(along * along * major * se_major, across * across * minor * se_minor) / width
                    : std::hypot(along * se_major, across * se_minor);
    const double error = std::hypot(statistical, grid_allowance(expected[i], pixel)),
                 deviation = std::abs(width - expected[i]);
    if (error > 0.0) result[i].z = deviation / error;
    result[i].resolved = expected[i] >= resolved_axis_px * pixel;
    if (result[i].resolved) result[i].relative = deviation / expected[i];
  }
  return result;
}

/// Where a centroid is from its predicted place along one axis.
struct Displacement {
  double px, error_px;  ///< error_px > 0
};

/// The predicted place is the chief ray's: the first-order footprint of a pupil is centred on it. The spot lies in the
/// middle of an even number of pixels, and both are symmetric about it: the grid has no share in the centroid.
std::array<std::optional<Displacement>, 2> psf_displacements(const PsfFinding& psf) {
  std::array<std::optional<Displacement>, 2> result;
  if (!psf.measured || !psf.measured->centroid_arcmin || !psf.measured->centroid_standard_error_arcmin) return result;
  if (!psf.pixel_arcmin || !(*psf.pixel_arcmin > 0.0)) return result;
  for (int i = 0; i < 2; ++i) {
    const double is = (*psf.measured->centroid_arcmin)(i), error = (*psf.measured->centroid_standard_error_arcmin)(i);
    if (error > 0.0) result[static_cast<std::size_t>(i)] = {is / *psf.pixel_arcmin, error / *psf.pixel_arcmin};
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
void add_judged(const std::vector<PsfFinding>& psfs, Measurements& out) {
  std::array<CommonDisplacement, 2> common;
  bool any = false;
  for (const PsfFinding& psf : psfs) {
    if (psf.ray_model != RayModel::power_matrix) continue;
    any = true;
    const auto deviations = psf_deviations(psf);
    const auto displacements = psf_displacements(psf);
    for (std::size_t i = 0; i < 2; ++i) {
      const std::optional<Displacement>& d = displacements[i];
      add(psf.id, centroid_z, d ? Number(std::abs(d->px) / d->error_px) : std::nullopt, out);
      common[i].add(d);
      const std::string name = psf.id + (i == 0 ? ", major axis" : ", minor axis");
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
void add_compared(const PsfFinding& psf, Measurements& out) {
  const std::string model = name_of(psf.ray_model);
  const MeasuredSpot measured = psf.measured.value_or(MeasuredSpot{});
  const auto& error = measured.standard_error_arcmin;
  const auto add_axis = [&](const char* axis, double Ellipse::*length, int index) {
    const auto of = [&](const std::optional<Ellipse>& e) { return e ? Number((*e).*length) : std::nullopt; };
    const std::string quantity = std::string("semi-") + axis + " axis [arcmin]";
    out.push_back({.section = "psfs",
                   .subject = psf.id,
                   .model = model,
                   .quantity = quantity,
                   .value = of(measured.ellipse),
                   .standard_error = error ? Number((*error)(index)) : std::nullopt,
                   .better = Better::Nearer,
                   .target = of(psf.predicted),
                   .run_name = "PSF " + psf.id + ", " + model + ": " + quantity});
  };
  add_axis("major", &Ellipse::semi_major, 0);
  add_axis("minor", &Ellipse::semi_minor, 1);
}

void add_row(const PsfFinding& psf, Measurements& out) {
  Number relative;
  if (psf.predicted && psf.measured && psf.measured->ellipse && psf.predicted->semi_major > 0.0)
    relative = std::abs(psf.measured->ellipse->semi_major / psf.predicted->semi_major - 1.0);
  out.push_back({.section = "psfs",
                 .subject = psf.id,
                 .model = name_of(psf.ray_model),
                 .quantity = "relative difference of major axes, from the conoid",
                 .value = relative,
                 .listed_as = relative ? CaseStatus::Measured : CaseStatus::NoResult});
}

}  // namespace

void measure_psfs(const Json& report, Measurements& out) {
  const std::vector<PsfFinding> psfs = read_psfs(report);
  add_judged(psfs, out);
  for (const PsfFinding& psf : psfs) {
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
