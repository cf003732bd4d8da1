#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/ellipses/ellipse_comparison.h"
#include "conoid/tracing/footprint.h"
#include "experiments/run/sections.h"
#include "io/files/error.h"
#include "io/json/values.h"

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

double relative_difference(const Eigen::Matrix2d& value, const Eigen::Matrix2d& reference) {
  const double scale = reference.norm();
  return scale > 0.0 ? (value - reference).norm() / scale : value.norm();
}

struct WorstErrors {
  double semi_axes = 0.0, covariance = 0.0, orientation_deg = 0.0, sin2 = 0.0;
};

void compare_case(const Json& entry, WorstErrors& worst) {
  const Json& in = entry.at("inputs");
  const Json& out = entry.at("outputs");
  const Json& distance = in.at("object_distance_m");
  const Eye eye = Eye::with({in.at("S"), in.at("C"), in.at("A"), 0.0}, 1e-3 * in.at("pupil_mm").get<double>());
  const Footprint footprint =
      naked_eye_footprint(eye, distance.is_string() ? std::numeric_limits<double>::infinity() : distance.get<double>());
  const double a = eye.pupil_radius_m;
  const Ellipse ellipse = Ellipse::image_of_disc(footprint.angular, a);

  const double major = out.at("semi_major_rad"), minor = out.at("semi_minor_rad");
  if (major > 0.0)
    worst.semi_axes = std::max(
        {worst.semi_axes, std::abs(ellipse.semi_major - major) / major, std::abs(ellipse.semi_minor - minor) / major});
  worst.covariance = std::max(worst.covariance, relative_difference(covariance_of_disc_image(footprint.angular, a),
                                                                    wearer_frame(out.at("cov_rad2_xx_xy_yy"))));
  worst.sin2 = std::max(worst.sin2, relative_difference(sin2_closed_form_covariance(footprint.angular, a),
                                                        wearer_frame(out.at("sin2_radial").at("cov_rad2_xx_xy_yy"))));
  const Json& orientation = out.at("major_orientation_deg");
  if (orientation.is_number()) {
    const double expected = wearer_orientation_deg(orientation.get<double>());
    const double error =
        ellipse.orientation_deg ? std::abs(std::remainder(*ellipse.orientation_deg - expected, 180.0)) : 90.0;
    worst.orientation_deg = std::max(worst.orientation_deg, error);
  }
}

}  // namespace

Json reference_agreement(const std::filesystem::path& reference_file) {
  const Json document = load_json(reference_file.string());
  WorstErrors worst;
  std::size_t cases = 0;
  try {
    for (const Json& entry : document.at("cases")) {
      compare_case(entry, worst);
      ++cases;
    }
  } catch (const Json::exception&) {
    throw InputError(reference_file.string(), "/cases/" + std::to_string(cases), "",
                     "inputs and outputs of a naked-eye blur case, all numbers present");
  }
  return {{"file", reference_file.filename().string()},
          {"cases", cases},
          {"max_relative_error",
           {{"conoid_semi_axes", worst.semi_axes},
            {"conoid_covariance", worst.covariance},
            {"conoid_orientation_half_turns", worst.orientation_deg / 180.0},
            {"sin2_closed_form", worst.sin2}}}};
}

}  // namespace sturm
