#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/experiment/sin2_study_spec.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// The ray models of the study.
inline constexpr std::array study_models{RayModel::metalstigmatism, RayModel::sin2_radial, RayModel::power_matrix};

/// What one of them is, in a few words.
const char* title_of(RayModel study_model);

/// What a case has in numbers.
enum class StudyQuantity {
  high_D,             ///< larger principal value V₁ of I/d + F − A·I
  low_D,              ///< smaller one, V₂
  true_major_arcmin,  ///< semi-axes of wavefront theory
  true_minor_arcmin,
  major_arcmin,  ///< measured, uniform pupil; semi-axes of second moments
  minor_arcmin,
  error_D,  ///< largest difference of the half-width in any direction from wavefront theory, over the pupil's radius
  error_arcmin,           ///< the same as an angle
  error_percent,          ///< the same of the true major semi-axis; none in perfect focus
  theory_deviation,       ///< relative_deviation() from wavefront theory
  closed_form_deviation,  ///< … from the model's own closed form
  radial_deviation_D,     ///< sin2_radial: largest difference from wavefront theory of a ray's slope within its own
                          ///< meridian, over r
  difference_ratio,       ///< measured difference of the principal variances over the true one; none for a circle
  lost_variance_ratio,    ///< lost total variance over a²C²/16; none without a cylinder
  polar_rms,  ///< root of the total variance with uniform_polar over that of the uniform pupil; none in perfect focus
  weighted_rms,              ///< … with uniform_polar_weighted
  rings_rms,                 ///< … with rings
  rays,                      ///< of the uniform pupil
  rays_dropped,              ///< there, at the pole
  rays_negative_focus,       ///< there, bent as if by a focus behind the eye
  repaired_deviation,        ///< sin2_radial with the tangential term, from wavefront theory
  mutant_repaired_as_sin2,   ///< sin2_radial with the tangential term, from the closed form of sin²
  mutant_wrong_coefficient,  ///< sin2_radial from a closed form with 4 in place of 5
  mutant_mirrored_axis,      ///< power_matrix from wavefront theory for AXIS 180 − α
  mutant_sin2_as_matrix,     ///< sin2_radial from wavefront theory
  count
};
inline constexpr std::size_t quantity_count = static_cast<std::size_t>(StudyQuantity::count);

/// Names of the quantities in stored parts and in sin2_study.csv, in their order.
const char* name_of(StudyQuantity quantity);

enum class StudyStatus {
  ok,
  undefined,  ///< metalstigmatism without a stated focus distance
  pole  ///< metalstigmatism with a meridian at or so near its pole that the second moments do not exist or are not
        ///< resolved
};
const char* name_of(StudyStatus status);

/// One prescription × distance × pupil × accommodation × ray model; indices into the spec's lists.
struct StudyCase {
  std::size_t eye = 0, distance = 0, pupil = 0, accommodation = 0;
  RayModel model = RayModel::power_matrix;  ///< one of study_models
  StudyStatus status = StudyStatus::ok;
  std::array<std::optional<double>, quantity_count> values{};

  std::optional<double>& operator[](StudyQuantity q) { return values[static_cast<std::size_t>(q)]; }
  const std::optional<double>& operator[](StudyQuantity q) const { return values[static_cast<std::size_t>(q)]; }
};

/// ‖is − should‖_F/(‖should‖_F + a²/4·(1 D)²): relative, except where there is less than a dioptre of blur, so that an
/// image in focus has a deviation, too. Covariances in rad², `a` in metres.
double relative_deviation(const Eigen::Matrix2d& is, const Eigen::Matrix2d& should, double a);

/// A case as an array of numbers, its model by the place in study_models, and back.
Json row_of(const StudyCase& c);
StudyCase case_of(const Json& row);

/// "-2.00 -1.50 × 30|1 m|4 mm|focus 1 m|sin2_radial".
std::string label_of(const StudyCase& c, const Sin2StudySpec& spec);

/// "relaxed", "focus 1 m", "accommodation 0.5 D" or "best, up to 2 D"; "inf" where it is at infinity.
std::string label_of(const Accommodation& accommodation);

/// All cases, RFC 4180, numbers with nine digits.
std::string sin2_study_csv(const std::vector<StudyCase>& cases, const Sin2StudySpec& spec);

}  // namespace sturm
