#include "io/specs/noted_prism.h"

#include <cmath>
#include <numbers>

namespace sturm {

Prism prism_of(const NotedPrescription& rx) {
  // The nose is on the examiner's right of a right eye.
  const double right = rx.prism_right + (rx.eye == EyeSide::left ? -rx.prism_nasal : rx.prism_nasal);
  double base_deg = std::atan2(rx.prism_up, right) * 180.0 / std::numbers::pi;
  if (base_deg < 0.0) base_deg += 360.0;
  return {std::hypot(right, rx.prism_up), base_deg};
}

}  // namespace sturm
