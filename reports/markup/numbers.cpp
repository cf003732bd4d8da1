#include "reports/markup/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "io/json/stored.h"

namespace sturm {

namespace {

constexpr const char* absent = "–";
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

std::string times_power_of_ten(int exponent) {
  return " × 10<sup>" + with_true_minus(std::to_string(exponent)) + "</sup>";
}

bool reads_well_in_fixed_notation(int exponent) {
  return exponent >= smallest_fixed_exponent && exponent <= largest_fixed_exponent;
}

}  // namespace

std::string number_html(std::optional<double> value, int significant) {
  if (!value || !std::isfinite(*value)) return absent;
  if (*value == 0.0) return "0";
  const int exponent = rounded_exponent(*value, significant);
  if (reads_well_in_fixed_notation(exponent)) return fixed(*value, significant - 1 - exponent);
  return fixed(*value / std::pow(10.0, exponent), significant - 1) + times_power_of_ten(exponent);
}

std::string exact_html(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return absent;
  const std::string text = formatted("%.*g", 12, *value);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return with_true_minus(text);
  return with_true_minus(text.substr(0, e)) + times_power_of_ten(std::stoi(text.substr(e + 1)));
}

std::string measured_html(std::optional<double> value, std::optional<double> uncertainty, int significant) {
  if (!value || !uncertainty || !std::isfinite(*value) || !std::isfinite(*uncertainty) || *uncertainty <= 0.0) {
    return number_html(value, significant);
  }
  const int decimals = 1 - rounded_exponent(*uncertainty, 2);
  const int exponent = rounded_exponent(std::max(std::abs(*value), *uncertainty), 2);
  if (reads_well_in_fixed_notation(exponent) && decimals <= 7)
    return fixed(*value, decimals) + " ± " + fixed(*uncertainty, decimals);
  const double scale = std::pow(10.0, exponent);
  std::string html = "(";
  html.append(fixed(*value / scale, decimals + exponent))
      .append(" ± ")
      .append(fixed(*uncertainty / scale, decimals + exponent));
  return html.append(")").append(times_power_of_ten(exponent));
}

std::string count_html(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return absent;
  std::string digits = formatted("%.*f", 0, std::abs(*value));
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, "\u2009");
  return digits.insert(0, *value < 0 ? "−" : "");
}

std::string duration_html(std::optional<double> seconds) {
  if (!seconds || !std::isfinite(*seconds)) return absent;
  if (*seconds < 100.0) return number_html(seconds, 2) + "\u00a0s";
  const long long whole = std::llround(*seconds);
  char buffer[64];
  if (whole < 3600) {
    std::snprintf(buffer, sizeof buffer, "%lld\u00a0min\u00a0%02lld\u00a0s", whole / 60, whole % 60);
  } else {
    std::snprintf(buffer, sizeof buffer, "%lld\u00a0h\u00a0%02lld\u00a0min", whole / 3600, whole % 3600 / 60);
  }
  return buffer;
}

std::string distance_html(const Json& distance_m) {
  return distance_m == "inf" ? "∞" : exact_html(number_at(distance_m, ""));
}

std::string distance_html(const std::optional<StoredDistance>& distance) {
  return distance && distance->is_infinite() ? "∞" : exact_html(finite(distance));
}

}  // namespace sturm
