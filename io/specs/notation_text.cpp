#include <cmath>

#include "io/files/number_text.h"
#include "io/specs/prescription_notation.h"

namespace sturm {

namespace {

/// Shortest digits that read back, at least two behind the point where they suffice, with a sign.
std::string signed_dioptres(double value) {
  std::string digits = shortest_fixed(value);
  if (digits.find('.') == std::string::npos) digits += '.';
  while (digits.size() - digits.find('.') < 3) digits += '0';
  return std::signbit(value) ? digits : "+" + digits;
}

}  // namespace

std::string in_notation(const NotedPrescription& rx) {
  std::string text;
  if (rx.eye) text = *rx.eye == EyeSide::right ? "OD " : "OS ";
  text += signed_dioptres(rx.sphere_D);
  if (rx.cylinder_D != 0.0)
    text += " " + signed_dioptres(rx.cylinder_D);
  else
    text += " DS";
  if (rx.axis_deg) text += " x " + shortest_fixed(*rx.axis_deg);
  if (rx.addition_D) text += " ADD " + signed_dioptres(*rx.addition_D);
  const auto prism = [&](double amount, const char* base, const char* other) {
    if (amount != 0.0) text += " " + shortest_fixed(std::abs(amount)) + "^ " + (amount > 0.0 ? base : other);
  };
  prism(rx.prism_nasal, "BI", "BO");
  prism(rx.prism_up, "BU", "BD");
  prism(rx.prism_right, "base 0", "base 180");
  if (rx.vertex_distance_mm) text += " VD " + shortest_fixed(*rx.vertex_distance_mm);
  return text;
}

}  // namespace sturm
