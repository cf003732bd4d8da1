#pragma once
#include <optional>

#include "io/json/json.h"
#include "io/json/record.h"
#include "reports/markup/html.h"

namespace sturm {

/// Numbers as a reader wants them: true minus signs, a thin power of ten where fixed notation would be long,
/// and "–" for a number that is absent. Nothing here ever writes NaN or inf.

/// Rounded to `significant` digits: "0.7071", "1.23 × 10⁻⁵" (with <sup>).
Html number_html(std::optional<double> value, int significant = 4);

/// A number that was chosen, not measured (a bound, a setting): as short as it can be written.
Html exact_html(std::optional<double> value);

/// Value ± standard uncertainty; the uncertainty has two significant digits and decides those of the value.
/// Without a (positive) uncertainty the value alone, with `significant` digits.
Html measured_html(std::optional<double> value, std::optional<double> uncertainty, int significant = 4);

/// The same with the uncertainty as a remark of its own, for a table as narrow as possible; in one line where a power
/// of ten stands behind both.
Html stacked_html(std::optional<double> value, std::optional<double> uncertainty);

/// A whole number with thin spaces between groups of three digits.
Html count_html(std::optional<double> value);

/// "8.2 s", "3 min 20 s", "1 h 05 min", with spaces that do not break.
Html duration_html(std::optional<double> seconds);

/// Metres, ∞ allowed.
Html distance_html(std::optional<double> distance_m);
Html distance_html(const std::optional<StoredDistance>& distance);

}  // namespace sturm
