#pragma once

namespace sturm {

/// A check of the study of sin² ("sin2_study.checks" of a report) as readers see it.
struct ShownCheck {
  const char* key;
  const char* what;  ///< plain text
  bool deviation;    ///< from what the number should be by theory: 0 is best. Otherwise a finding that is neither good
                     ///< nor bad
};

inline constexpr ShownCheck shown_checks[] = {
    {"matrix_vs_theory_max", "power-matrix rays against wavefront theory, largest deviation", true},
    {"sin2_vs_closed_form_max", "sin² rays against their closed form", true},
    {"metalstigmatism_vs_closed_form_max", "focal distances added, against their closed form", true},
    {"sin2_radial_part_max_D", "sin²: power within the ray's own meridian against theory [D]", true},
    {"sin2_without_cylinder_max", "sin² without a cylinder, against theory", true},
    {"sin2_half_difference_max_deviation",
     "sin²: difference of the principal variances over the true one, largest distance from ½", true},
    {"sin2_lost_variance_max_deviation", "sin²: lost total variance over a²C²/16, largest distance from 1", true},
    {"sin2_error_per_cylinder_min", "sin²: smallest error per dioptre of cylinder", false},
    {"sin2_error_per_cylinder_max", "sin²: largest error per dioptre of cylinder", false},
    {"line_focus_length_max_deviation", "line focus: length over the true one, largest distance from 0.7906", true},
    {"line_focus_width_max_deviation", "line focus: false width over the true length, largest distance from 0.3536",
     true},
    {"circle_radius_max_deviation", "circle of least confusion: radius over the true one, largest distance from 0.7071",
     true},
    {"repaired_vs_theory_max", "sin² with the tangential term, against theory", true},
    {"emmetrope_focused_at_infinity_max_deviation",
     "focal distances added, no prescription: error at the focus times its distance, largest distance from 1", true},
    {"polar_rms_max_deviation", "uniform_polar: rms blur over the uniform pupil's, largest distance from √(2/3)", true},
    {"polar_weighted_rms_max_deviation", "uniform_polar_weighted: the same, largest distance from 1", true},
    {"rings_rms_max_deviation", "rings: the same, largest distance from √((n + 1)/n)", true}};

}  // namespace sturm
