#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compare/gates/extreme_statistic.h"
#include "io/json/record.h"

namespace sturm {

/// How the real rays were sampled, and between which pupils orders were fitted.
struct LensStudyConditions {
  Count radial{}, azimuthal{};
  std::array<Number, 2> order_pupils_mm{};
  Number rotation_center_mm{};

  bool operator==(const LensStudyConditions&) const = default;
};

/// An eye and its lens.
struct LensFacts {
  std::string id{}, note{};
  std::optional<bool> lens_of_revolution{}, analytic_surfaces{};
  Number sphere_D{}, cylinder_D{}, axis_deg{}, vertex_distance_mm{};

  bool operator==(const LensFacts&) const = default;
};

/// What became of conoid tracing as published (eq. 11), by the two readings of its tangent axes: "ok", "free_axes",
/// "no_length", "singular", "negative" or "lost".
struct Eq11Outcome {
  std::string principal{}, incidence{};

  bool operator==(const Eq11Outcome&) const = default;
};

/// One line of sight through one lens.
struct LensGaze {
  std::string lens{};
  Number eccentricity_deg{}, direction_deg{};  ///< from the lens's axis and about it; no direction straight ahead
  std::array<Number, 2> gaze_deg{};
  std::string status{};  ///< "ok", or what became of the chief ray
  std::optional<Eq11Outcome> eq11{};

  bool operator==(const LensGaze&) const = default;
};

/// A method's first order against the exact one: the same at every pupil.
struct FirstOrderError {
  Number relative_frobenius{}, defocus_D{};

  bool operator==(const FirstOrderError&) const = default;
};

struct FirstOrderErrors {
  std::optional<FirstOrderError> published{}, previous{};

  bool operator==(const FirstOrderErrors&) const = default;
};

/// A method's blur against real rays at one pupil.
struct MethodError {
  Number relative_frobenius{};
  std::array<Number, 2> semi_axes_arcmin{};
  Number half_width_arcmin{}, defocus_D{};

  bool operator==(const MethodError&) const = default;
};

/// A view at one pupil. Without errors: the method has no ellipse there, or real rays were lost.
struct LensPupil {
  Number pupil_mm{};
  Count rays_lost{};
  std::optional<std::array<Number, 2>> real_semi_axes_arcmin{};
  std::optional<MethodError> ray_transfer{}, published{}, previous{};

  bool operator==(const LensPupil&) const = default;
};

/// The order of convergence of footprints that are wrong on purpose.
struct MutantOrders {
  Number published_as_exact{}, mirrored_gaze{};

  bool operator==(const MutantOrders&) const = default;
};

/// One target seen along a gaze whose chief ray comes through.
struct LensStudyView {
  std::string lens{};
  Number eccentricity_deg{}, direction_deg{};
  std::optional<StoredDistance> distance_m{};
  std::array<Number, 2> blur_D{};  ///< principal blur, the larger first
  FirstOrderErrors first_order{};
  Number previous_unscaled_error{};  ///< of the previous method once its scaling to the object is the true one
  Number order{}, relative_order{};  ///< of the error of ray transfer in the pupil's diameter
  Number limit_relative{};           ///< of that error, extrapolated to the pupil 0
  MutantOrders mutant_orders{};
  std::vector<LensPupil> pupils{};

  Number finite_distance_m() const { return finite(distance_m); }
  bool operator==(const LensStudyView&) const = default;
};

struct FieldEllipse {
  std::array<Number, 2> semi_axes_arcmin{};
  Number orientation_deg{};

  bool operator==(const FieldEllipse&) const = default;
};

struct FieldPoint {
  Number azimuth_deg{};
  std::string status{};
  std::optional<FieldEllipse> real_rays{}, ray_transfer{}, published{}, previous{};

  bool operator==(const FieldPoint&) const = default;
};

/// The ellipses of all methods over the wide field.
struct LensField {
  std::string lens{};
  std::optional<StoredDistance> distance_m{};
  Number pupil_mm{};
  std::vector<FieldPoint> points{};

  bool operator==(const LensField&) const = default;
};

/// Section "lens_study" of a report.
struct LensFindings {
  LensStudyConditions conditions{};
  std::vector<LensFacts> lenses{};
  std::vector<LensGaze> gazes{};
  std::vector<LensStudyView> views{};
  std::optional<LensField> field{};

  bool operator==(const LensFindings&) const = default;
};

/// What one lens gives: its share of the section.
struct LensPart {
  LensFacts lens{};
  std::vector<LensGaze> gazes{};
  std::vector<LensStudyView> views{};
};

Json to_json(const LensFindings& findings);

/// Of a report; none without the section.
std::optional<LensFindings> lens_findings(const Json& report);

/// The steps of the run, both ways.
Json to_json(const LensPart& part);
LensPart lens_part_from(const Json& json);
Json to_json(const LensField& field);
LensField lens_field_from(const Json& json);

}  // namespace sturm
