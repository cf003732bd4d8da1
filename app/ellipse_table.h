#pragma once
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/ellipse_query.h"

namespace sturm {

/// A query with the answer of `blur_ellipses`.
struct AnsweredQuery {
  std::string name;
  EllipseQuery query;
  Json answer;
};

/// The answers as a table for people: a line for each target and method. Several queries have a column with their
/// names.
std::string ellipse_table(const std::vector<AnsweredQuery>& answers);

/// The same as a table for programs, with all digits.
std::string ellipse_csv(const std::vector<AnsweredQuery>& answers);

/// One entry of `results` in words: "blurred along 70°; lines along 70° clear at 0.21 m, along 160° at 0.32 m".
std::string ellipse_in_words(const Json& result);

}  // namespace sturm
