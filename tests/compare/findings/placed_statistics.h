#pragma once
#include <optional>
#include <string>

#include "io/json/json.h"

namespace sturm::testing {

/// A healthy report in which `statistic` has the value `value` by a number that was put where the program writes it;
/// none for a statistic that no place is known of. Counts are rounded down. Statistics of images against a baseline are
/// placed by `with_fallen_images`.
std::optional<Json> report_with(const std::string& statistic, double value);

/// The healthy report with one image whose SSIM is this many standard errors (of the difference) lower than in the
/// healthy report.
Json with_fallen_images(double standard_errors);

}  // namespace sturm::testing
