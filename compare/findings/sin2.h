#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/findings/measurement.h"
#include "io/json/json.h"
#include "lensmodel/ellipse.h"

namespace sturm {

/// What sin² rays make of one case with a cylinder. Semi-axes (major, minor) in arcmin.
struct Sin2Case {
  std::string id;
  Number high_D, low_D;  ///< principal values V₁, V₂ of I/d + F − A·I
  std::optional<Eigen::Vector2d> true_semi_axes_arcmin, sin2_semi_axes_arcmin, closed_form_semi_axes_arcmin;
  Number ratio_major, ratio_minor;  ///< measured over true; none where the true axis is (nearly) zero
};

/// Difference of the principal variances of sin² rays over that of wavefront theory.
struct VarianceRatio {
  Number measured_median, predicted, worst_deviation;
};

/// Section "sin2": what sin² interpolation does to an astigmatic pupil, against its closed form.
struct Sin2Findings {
  std::optional<std::uint64_t> cases_with_cylinder;
  std::vector<Sin2Case> table;
  std::optional<VarianceRatio> ratio;  ///< none without a case that it can be told in
  Number
      worst_deviation_of_lost_variance;  ///< of the total variance that is lost from a²C²/16, relative; none likewise
};

Json to_json(const Sin2Findings& findings);

/// Of a report ("sturm.report/1"); none without the section.
std::optional<Sin2Findings> read_sin2(const Json& report);

}  // namespace sturm
