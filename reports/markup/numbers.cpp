#include "reports/markup/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "reports/markup/parts.h"

namespace sturm {

namespace {

constexpr int smallest_fixed_exponent = -3, largest_fixed_exponent = 5;

std::string formatted(const char* format, int precision, double value) {
  char buffer[400];
  return {buffer, static_cast<std::size_t>(std::snprintf(buffer, sizeof buffer, format, precision, value))};
}

/// Decimal exponent after rounding to `significant` digits: 9.999 with 3 digits has exponent 1.
int rounded_exponent(double value, int significant) {
  const std::string text = formatted("%.*e", significant - 1, value);
  return std::stoi(text.substr(text.find('e') + 1));
}

std::string with_true_minus(std::string text) {
  if (!text.empty() && text[0] == '-') {
    const bool zero = text.find_first_of("123456789") == std::string::npos;
    text.replace(0, 1, zero ? "" : "−");
  }
  return text;
}

std::string fixed(double value, int decimals) {
  return with_true_minus(formatted("%.*f", std::clamp(decimals, 0, 60), value));
}

Html times_power_of_ten(int exponent) {
  return " × 10"_html + inline_element("sup", text(with_true_minus(std::to_string(exponent))));
}

bool reads_well_in_fixed_notation(int exponent) {
  return exponent >= smallest_fixed_exponent && exponent <= largest_fixed_exponent;
}

/// A value and its uncertainty with the same decimals.
struct Measured {
  std::string value, uncertainty;
  std::optional<int> exponent;  ///< of the power of ten that stands behind both, if any
};

/// None without a value or without a (positive) uncertainty.
std::optional<Measured> measured(std::optional<double> value, std::optional<double> uncertainty) {
  if (!value || !uncertainty || !std::isfinite(*value) || !std::isfinite(*uncertainty) || *uncertainty <= 0.0)
    return std::nullopt;
  const int decimals = 1 - rounded_exponent(*uncertainty, 2);
  const int exponent = rounded_exponent(std::max(std::abs(*value), *uncertainty), 2);
  if (reads_well_in_fixed_notation(exponent) && decimals <= 7)
    return Measured{fixed(*value, decimals), fixed(*uncertainty, decimals), std::nullopt};
  const double scale = std::pow(10.0, exponent);
  return Measured{fixed(*value / scale, decimals + exponent), fixed(*uncertainty / scale, decimals + exponent),
                  exponent};
}

}  // namespace

Html number_html(std::optional<double> value, int significant) {
  if (!value || !std::isfinite(*value)) return absent_html();
  if (*value == 0.0) return "0"_html;
  const int exponent = rounded_exponent(*value, significant);
  if (reads_well_in_fixed_notation(exponent)) return text(fixed(*value, significant - 1 - exponent));
  return text(fixed(*value / std::pow(10.0, exponent), significant - 1)) + times_power_of_ten(exponent);
}

Html exact_html(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return absent_html();
  const std::string digits = formatted("%.*g", 12, *value);
  const std::size_t e = digits.find('e');
  if (e == std::string::npos) return text(with_true_minus(digits));
  return text(with_true_minus(digits.substr(0, e))) + times_power_of_ten(std::stoi(digits.substr(e + 1)));
}

Html measured_html(std::optional<double> value, std::optional<double> uncertainty, int significant) {
  const std::optional<Measured> m = measured(value, uncertainty);
  if (!m) return number_html(value, significant);
  const Html both = text(m->value) + " ± "_html + text(m->uncertainty);
  return m->exponent ? "("_html + both + ")"_html + times_power_of_ten(*m->exponent) : both;
}

Html stacked_html(std::optional<double> value, std::optional<double> uncertainty) {
  const std::optional<Measured> m = measured(value, uncertainty);
  if (!m || m->exponent) return measured_html(value, uncertainty);
  return text(m->value) + small_html("± "_html + text(m->uncertainty));
}

Html count_html(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return absent_html();
  std::string digits = formatted("%.*f", 0, std::abs(*value));
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, "\u2009");
  return text(digits.insert(0, *value < 0 ? "−" : ""));
}

Html duration_html(std::optional<double> seconds) {
  if (!seconds || !std::isfinite(*seconds)) return absent_html();
  if (*seconds < 100.0) return number_html(seconds, 2) + "\u00a0s"_html;
  const long long whole = std::llround(*seconds);
  char buffer[64];
  if (whole < 3600) {
    std::snprintf(buffer, sizeof buffer, "%lld\u00a0min\u00a0%02lld\u00a0s", whole / 60, whole % 60);
  } else {
    std::snprintf(buffer, sizeof buffer, "%lld\u00a0h\u00a0%02lld\u00a0min", whole / 3600, whole % 3600 / 60);
  }
  return text(buffer);
}

Html distance_html(std::optional<double> distance_m) {
  return distance_m && std::isinf(*distance_m) ? "∞"_html : exact_html(distance_m);
}

Html distance_html(const std::optional<StoredDistance>& distance) {
  return distance && distance->is_infinite() ? "∞"_html : exact_html(finite(distance));
}

}  // namespace sturm
