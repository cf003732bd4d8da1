#include "io/specs/prescription_notation.h"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/files/error.h"
#include "io/files/text_encoding.h"
#include "io/specs/notation_parser.h"

namespace sturm {

namespace {

/// Shortest digits that read back, at least two behind the point where they suffice, with a sign.
std::string signed_dioptres(double value) {
  std::array<char, 64> text;
  const auto fixed = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  std::string digits(text.data(), fixed.ptr);
  if (digits.find('.') == std::string::npos) digits += '.';
  while (digits.size() - digits.find('.') < 3) digits += '0';
  return std::signbit(value) ? digits : "+" + digits;
}

/// OU: one prescription for both eyes.
bool are_alike(NotedPrescription a, NotedPrescription b) {
  a.eye.reset(), b.eye.reset();
  return in_notation(a) == in_notation(b) && a.prism_nasal == 0.0;
}

std::string plain(double value) {
  std::array<char, 64> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr};
}

}  // namespace

std::vector<NotedPrescription> parse_prescription_notation(std::string_view text) {
  return NotationParser(notation_tokens(text)).run();
}

std::string in_notation(const NotedPrescription& rx) {
  std::string text;
  if (rx.eye) text = *rx.eye == EyeSide::right ? "OD " : "OS ";
  text += signed_dioptres(rx.sphere_D);
  if (rx.cylinder_D != 0.0)
    text += " " + signed_dioptres(rx.cylinder_D);
  else
    text += " DS";
  if (rx.axis_deg) text += " x " + plain(*rx.axis_deg);
  if (rx.addition_D) text += " ADD " + signed_dioptres(*rx.addition_D);
  const auto prism = [&](double amount, const char* base, const char* other) {
    if (amount != 0.0) text += " " + plain(std::abs(amount)) + "^ " + (amount > 0.0 ? base : other);
  };
  prism(rx.prism_nasal, "BI", "BO");
  prism(rx.prism_up, "BU", "BD");
  prism(rx.prism_right, "base 0", "base 180");
  if (rx.vertex_distance_mm) text += " VD " + plain(*rx.vertex_distance_mm);
  return text;
}

NotedPrescription read_notation(std::string_view text, const Source& where, std::optional<EyeSide> eye) {
  const auto refuse = [&](const std::string& expected) {
    throw InputError(where.file, where.pointer, "\"" + shortened(utf8_text(std::string(text))) + "\"", expected);
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
  // The nose is on the examiner's right of a right eye.
  const double right = rx.prism_right + (rx.eye == EyeSide::left ? -rx.prism_nasal : rx.prism_nasal);
  object["prism_cm_per_m"] = std::hypot(right, rx.prism_up);
  double base_deg = std::atan2(rx.prism_up, right) * 180.0 / std::numbers::pi;
  if (base_deg < 0.0) base_deg += 360.0;
  object["prism_base_deg"] = base_deg;
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
