#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compare/ellipses/ellipse_measures.h"
#include "compare/findings/measurement.h"
#include "io/json/json.h"
#include "lensmodel/ellipse.h"
#include "lensmodel/ray_model.h"
#include "lensmodel/words.h"

namespace sturm {

/// How the rays of all cases were sampled, in words where they are words.
struct EllipseConditions {
  std::optional<std::uint64_t> rays_per_replicate, replicates;
  std::string sampling, sequence, standard_error;
};

/// A measured covariance against a predicted one, as far as gates look at it.
struct EllipseAgreement {
  Number z_max;               ///< largest |z| of its entries
  Number relative_frobenius;  ///< relative to the predicted one; none for a predicted point
};

/// All measures of compare/ellipses/ellipse_measures.h in the units of the report; none where a measure means nothing.
struct EllipseDifferences {
  std::optional<EllipseMeasure> semi_major_arcmin, semi_minor_arcmin, orientation_deg, log_area_ratio,
      frobenius_arcmin2, bures_wasserstein_arcmin, missing_overlap;
};

/// Rays against the conoid.
struct ConoidComparison {
  EllipseAgreement agreement;
  std::optional<EllipseDifferences> differences;  ///< none: only what follows was computed
  std::array<Number, 2> semi_axis_errors;         ///< relative; major, minor
  Number minor_axis_error_arcmin, orientation_error_deg, bures_wasserstein_arcmin;
};

enum class RayStatus {
  Ok,
  Undefined  ///< the model has no rays there, or too few of them arrived
};
inline constexpr Words<RayStatus, 2> ray_status_words{{{RayStatus::Ok, "ok"}, {RayStatus::Undefined, "undefined"}}};

/// What became of the rays of a bundle.
struct RayCounts {
  std::uint64_t launched = 0, dropped = 0, negative_focus = 0;
};

/// The rays of one model in a case. Angles from the chief ray in radians.
struct RayFinding {
  std::optional<RayModel> model;
  std::optional<RayStatus> status;
  std::optional<RayCounts> counts;  ///< none where the model has no rays
  std::optional<Ellipse> ellipse;
  std::optional<Eigen::Matrix2d> covariance_rad2;
  std::optional<Eigen::Vector3d> covariance_standard_error_rad2;  ///< of (xx, xy, yy)
  std::optional<ConoidComparison> against_conoid;
  std::optional<EllipseAgreement> against_closed_form;  ///< sin2_radial alone

  /// What the model has to agree with: sin² with its closed form, everything else with the conoid.
  EllipseAgreement own_agreement() const;
};

/// A predicted ellipse, as angles in radians.
struct PredictedEllipse {
  std::optional<Ellipse> ellipse;
  std::optional<Eigen::Matrix2d> covariance_rad2;
};

/// One prescription × distance × pupil.
struct EllipseFinding {
  std::string id, prescription;  ///< of the case, of its prescription
  Number sphere_D, cylinder_D, axis_deg, vertex_distance_mm;
  Number distance_m;  ///< may be ∞
  Number pupil_mm, accommodation_D;
  PredictedEllipse conoid, sin2_closed_form;
  std::vector<RayFinding> rays;
  std::map<std::string, EllipseFinding>
      mutated;  ///< what it would be with a predictor made wrong, by the mutation's id

  const RayFinding* rays_of(RayModel model) const;  ///< null if there are none

  /// Frobenius distance of the covariances of sin² and conoid, as predicted, relative to the conoid's.
  Number predicted_difference() const;
};

/// Section "ellipses": blur ellipses of rays against the conoid and against the closed form of sin².
struct EllipseFindings {
  EllipseConditions conditions;
  std::vector<EllipseFinding> cases;
};

Json to_json(const EllipseFinding& finding);
Json to_json(const EllipseFindings& findings);

/// Of a report ("sturm.report/1").
EllipseFindings read_ellipses(const Json& report);

}  // namespace sturm
