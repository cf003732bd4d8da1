#pragma once
#include <optional>
#include <string>

#include "io/json/json.h"
#include "io/json/record.h"

namespace sturm {

/// Numbers as a reader wants them, as HTML: true minus signs, a thin power of ten where fixed notation would be long,
/// and "–" for a number that is absent. Nothing here ever writes NaN or inf.

/// Rounded to `significant` digits: "0.7071", "1.23 × 10⁻⁵" (with <sup>).
std::string number_html(std::optional<double> value, int significant = 4);

/// A number that was chosen, not measured (a bound, a setting): as short as it can be written.
std::string exact_html(std::optional<double> value);

/// Value ± standard uncertainty; the uncertainty has two significant digits and decides those of the value.
/// Without a (positive) uncertainty the value alone, with `significant` digits.
std::string measured_html(std::optional<double> value, std::optional<double> uncertainty, int significant = 4);

/// A whole number with thin spaces between groups of three digits.
std::string count_html(std::optional<double> value);

/// "8.2 s", "3 min 20 s", "1 h 05 min", with spaces that do not break.
std::string duration_html(std::optional<double> seconds);

/// A distance of the report: metres as a number, or the text "inf" → "∞".
std::string distance_html(const Json& distance_m);
std::string distance_html(const std::optional<StoredDistance>& distance);

}  // namespace sturm
