#include "io/specs/prescription_notation.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/files/text_encoding.h"
#include "io/specs/notation_parser.h"
#include "io/specs/noted_prism.h"

namespace sturm {

namespace {

/// OU: one prescription for both eyes.
bool are_alike(NotedPrescription a, NotedPrescription b) {
  a.eye.reset(), b.eye.reset();
  return in_notation(a) == in_notation(b) && a.prism_nasal == 0.0;
}

}  // namespace

std::vector<NotedPrescription> parse_prescription_notation(std::string_view text) {
  return NotationParser(notation_tokens(text)).run();
}

NotedPrescription read_notation(std::string_view text, const Source& where, std::optional<EyeSide> eye) {
  const auto refuse = [&](const std::string& expected) {
    throw InputError(where.file, where.pointer, "\"" + readable(utf8_text(std::string(text)), 80) + "\"", expected);
  };
  std::vector<NotedPrescription> eyes;
  try {
    eyes = parse_prescription_notation(text);
  } catch (const NotationError& error) {
    refuse(error.what());
  }
  if (eyes.size() > 1 && !eye && are_alike(eyes[0], eyes[1])) {
    eyes.resize(1);
    eyes[0].eye.reset();
  }
  if (eyes.size() > 1 && !eye)
    refuse("the prescription of one eye: \"" + in_notation(eyes[0]) + "\" or \"" + in_notation(eyes[1]) + "\"");
  for (NotedPrescription& rx : eyes) {
    if (eye && rx.eye && *rx.eye != *eye) continue;
    if (!rx.eye) rx.eye = eye;
    return rx;
  }
  refuse(std::string("the prescription of the ") + (*eye == EyeSide::right ? "right" : "left") + " eye");
  return {};
}

Json prescription_object(const NotedPrescription& rx, const Source& where) {
  Json object = {{"sphere_D", rx.sphere_D}, {"cylinder_D", rx.cylinder_D}};
  if (rx.axis_deg) object["axis_deg"] = *rx.axis_deg;
  if (rx.vertex_distance_mm) object["vertex_distance_mm"] = *rx.vertex_distance_mm;
  if (!rx.has_prism()) return object;
  if (rx.prism_nasal != 0.0 && !rx.eye)
    throw InputError(where.file, where.pointer, "\"" + in_notation(rx) + "\"",
                     "OD or OS before a prism with its base in or out, which lies on either side of the two eyes");
  const Prism prism = prism_of(rx);
  object["prism_cm_per_m"] = prism.cm_per_m;
  object["prism_base_deg"] = prism.base_deg;
  return object;
}

std::optional<EyeSide> eye_side(std::string_view text) {
  try {
    for (const NotationToken& token : notation_tokens(text)) {
      if (token.term == Term::right_eye && !token.is_number) return EyeSide::right;
      if (token.term == Term::left_eye && !token.is_number) return EyeSide::left;
    }
  } catch (const NotationError&) {
    return std::nullopt;  // a name of any other kind
  }
  return std::nullopt;
}

}  // namespace sturm
