#pragma once
#include <string>

#include "io/json/json.h"
#include "io/specs/ellipse_query.h"

namespace sturm {

/// The answer of `blur_ellipses` as a table for people: a line for each target and method.
std::string ellipse_table(const Json& answer, const EllipseQuery& query);

/// The same as a table for programs, with all digits.
std::string ellipse_csv(const Json& answer, const EllipseQuery& query);

/// One entry of `results` in words: "blurred along 70°; lines along 70° clear at 0.21 m, along 160° at 0.32 m".
std::string ellipse_in_words(const Json& result);

}  // namespace sturm
