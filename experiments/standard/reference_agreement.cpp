#include "experiments/standard/reference_agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/ellipses/ellipse_comparison.h"
#include "conoid/tracing/footprint.h"
#include "io/files/error.h"

namespace sturm {

namespace {

/// The reference is in the examiner's frame: seen from the wearer x is flipped, so the mixed entry changes sign.
Eigen::Matrix2d wearer_frame(const Json& xx_xy_yy) {
  Eigen::Matrix2d m;
  const double xy = -xx_xy_yy.at(1).get<double>();
  m << xx_xy_yy.at(0).get<double>(), xy, xy, xx_xy_yy.at(2).get<double>();
  return m;
}

double wearer_orientation_deg(double examiner_deg) {
  const double flipped = 180.0 - examiner_deg;
  return flipped > 90.0 ? flipped - 180.0 : flipped;
}

/// A naked eye's blur as other programs have it, in the wearer's frame.
struct ReferenceCase {
  Prescription prescription;
  double pupil_m, distance_m;  ///< diameter; may be ∞
  double semi_major_rad, semi_minor_rad;
  std::optional<double> orientation_deg;  ///< of the major axis; none for a circle
  Eigen::Matrix2d covariance_rad2, sin2_covariance_rad2;
};

/// Throws Json::exception where a number is missing.
ReferenceCase read_case(const Json& entry) {
  const Json &in = entry.at("inputs"), &out = entry.at("outputs");
  const Json &distance = in.at("object_distance_m"), &orientation = out.at("major_orientation_deg");
  return {.prescription = {in.at("S"), in.at("C"), in.at("A"), 0.0},
          .pupil_m = 1e-3 * in.at("pupil_mm").get<double>(),
          .distance_m = distance.is_string() ? std::numeric_limits<double>::infinity() : distance.get<double>(),
          .semi_major_rad = out.at("semi_major_rad"),
          .semi_minor_rad = out.at("semi_minor_rad"),
          .orientation_deg =
              orientation.is_number() ? std::optional(wearer_orientation_deg(orientation.get<double>())) : std::nullopt,
          .covariance_rad2 = wearer_frame(out.at("cov_rad2_xx_xy_yy")),
          .sin2_covariance_rad2 = wearer_frame(out.at("sin2_radial").at("cov_rad2_xx_xy_yy"))};
}

double relative_difference(const Eigen::Matrix2d& value, const Eigen::Matrix2d& reference) {
  const double scale = reference.norm();
  return scale > 0.0 ? (value - reference).norm() / scale : value.norm();
}

struct WorstErrors {
  double semi_axes = 0.0, covariance = 0.0, orientation_deg = 0.0, sin2 = 0.0;
};

void compare_case(const ReferenceCase& reference, WorstErrors& worst) {
  const Eye eye = Eye::with(reference.prescription, reference.pupil_m);
  const Footprint footprint = naked_eye_footprint(eye, reference.distance_m);
  const double a = eye.pupil_radius_m, major = reference.semi_major_rad, minor = reference.semi_minor_rad;
  const Ellipse ellipse = Ellipse::image_of_disc(footprint.angular, a);
  if (major > 0.0)
    worst.semi_axes = std::max(
        {worst.semi_axes, std::abs(ellipse.semi_major - major) / major, std::abs(ellipse.semi_minor - minor) / major});
  worst.covariance = std::max(
      worst.covariance, relative_difference(covariance_of_disc_image(footprint.angular, a), reference.covariance_rad2));
  worst.sin2 = std::max(worst.sin2, relative_difference(sin2_closed_form_covariance(footprint.angular, a),
                                                        reference.sin2_covariance_rad2));
  if (const auto& expected = reference.orientation_deg) {
    const double error =
        ellipse.orientation_deg ? std::abs(std::remainder(*ellipse.orientation_deg - *expected, 180.0)) : 90.0;
    worst.orientation_deg = std::max(worst.orientation_deg, error);
  }
}

}  // namespace

ReferenceFinding reference_agreement(const std::filesystem::path& reference_file) {
  const Json document = load_json(reference_file.string());
  WorstErrors worst;
  std::size_t cases = 0;
  try {
    for (const Json& entry : document.at("cases")) {
      compare_case(read_case(entry), worst);
      ++cases;
    }
  } catch (const Json::exception&) {
    throw InputError(reference_file.string(), "/cases/" + std::to_string(cases), "",
                     "inputs and outputs of a naked-eye blur case, all numbers present");
  }
  return {.file = reference_file.filename().string(),
          .cases = cases,
          .max_relative_error = {{"conoid_semi_axes", worst.semi_axes},
                                 {"conoid_covariance", worst.covariance},
                                 {"conoid_orientation_half_turns", worst.orientation_deg / 180.0},
                                 {"sin2_closed_form", worst.sin2}}};
}

}  // namespace sturm
