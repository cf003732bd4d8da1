#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json/json.h"

namespace sturm {
/// The wearer's right (OD) or left (OS) eye.
enum class EyeSide { right, left };

/// What a text in optical notation says of one eye (docs/formats/prescriptions.md).
struct NotedPrescription {
  std::optional<EyeSide> eye;                            ///< none where the text names none
  double sphere_D = 0.0, cylinder_D = 0.0;               ///< [D]; 0 for PL
  std::optional<double> axis_deg;                        ///< always there where there is a cylinder
  std::optional<double> addition_D, vertex_distance_mm;  ///< none where the text does not say

  // Prism [cm/m] by where its base is, as an examiner faces the wearer.
  double prism_right = 0.0, prism_up = 0.0;  ///< base to the examiner's right, and up; negative: left, and down
  double prism_nasal = 0.0;                  ///< base in; where that is depends on the eye

  bool has_prism() const { return prism_right != 0.0 || prism_up != 0.0 || prism_nasal != 0.0; }  ///< in any direction
};

/// Reads "-2.00 -1.50 x 30", "OD PL -0.75 x 180 OS +1.25 DS", … One element, or one for each eye that is named. Throws
/// NotationError (io/specs/notation_tokens.h), which says how an ambiguous text could be read.
std::vector<NotedPrescription> parse_prescription_notation(std::string_view text);

/// The same prescription in the notation's plainest form: "OD -2.00 -1.50 x 30 ADD +2.00 VD 12".
std::string in_notation(const NotedPrescription& rx);

/// The one prescription of a text at `where` that is meant for `eye`. Throws InputError for a text that cannot be read,
/// that is for the other eye, or that is for both where `eye` is not known.
NotedPrescription read_notation(std::string_view text, const Source& where, std::optional<EyeSide> eye = std::nullopt);

/// Prescription objects of documents (configs/schemas/eye.schema.json) without the addition, which they do not have.
/// Throws InputError about `where` for a prism with its base in or out where the eye is not known.
Json prescription_object(const NotedPrescription& rx, const Source& where);

/// The eye that "right", "OD", "L", … in a table or a document names; none where it names none.
std::optional<EyeSide> eye_side(std::string_view text);

}  // namespace sturm
