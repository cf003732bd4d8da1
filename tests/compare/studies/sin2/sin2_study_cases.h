#pragma once
#include <initializer_list>
#include <limits>
#include <utility>

#include "compare/studies/sin2/study_case.h"

/// A study of sin² with four eyes, made by hand: a grid of three (no correction, 0 −2 × 30 and 0 −2 × 90) and two real
/// ones.
namespace sturm::testing {

inline constexpr std::size_t round_eye = 0, toric_eye = 1, same_toric_eye = 2, first_real_eye = 3, second_real_eye = 4;
inline constexpr std::size_t at_1_m = 0, at_half_a_metre = 1, far = 2;
inline constexpr std::size_t relaxed = 0, focus_1_m = 1, focus_half_a_metre = 2, focus_far = 3;

inline Sin2StudySpec sin2_spec() {
  Sin2StudySpec spec;
  spec.eyes = {{"round", {}},
               {"toric", {.cylinder_D = -2.0, .axis_deg = 30.0}},
               {"same toric", {.cylinder_D = -2.0, .axis_deg = 90.0}},
               {"A OD", {.sphere_D = -2.5, .cylinder_D = -3.25, .axis_deg = 35.0}},
               {"A OS", {.sphere_D = 0.5}}};
  spec.grid_eyes = 3;
  spec.spheres_D = {0.0, 1.0};
  spec.cylinders_D = {0.0, -2.0};
  spec.distances_m = {1.0, 0.5, std::numeric_limits<double>::infinity()};
  spec.pupil_diameters_m = {2e-3, 4e-3};
  spec.accommodations = {RelaxedAccommodation{}, FixedAccommodation{.focus_distance_m = 1.0},
                         FixedAccommodation{.focus_distance_m = 0.5},
                         FixedAccommodation{.focus_distance_m = std::numeric_limits<double>::infinity()}};
  spec.rings.rings = 4;
  spec.reference_pupil = 1;
  spec.reference_distance = at_1_m;
  spec.reference_accommodation = relaxed;
  return spec;
}

using Numbers = std::initializer_list<std::pair<StudyQuantity, double>>;

/// At 1 m through the pupil that figures show, relaxed.
inline StudyCase study_case(RayModel model, std::size_t eye, Numbers numbers, StudyStatus status = StudyStatus::ok) {
  StudyCase c;
  c.eye = eye;
  c.pupil = 1;
  c.model = model;
  c.status = status;
  for (const auto& [quantity, value] : numbers) c[quantity] = value;
  return c;
}

/// The same seen from elsewhere.
inline StudyCase seen(StudyCase c, std::size_t distance, std::size_t accommodation) {
  c.distance = distance;
  c.accommodation = accommodation;
  return c;
}

}  // namespace sturm::testing
