#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/io_testing.h"
#include "io/json/json_pointer_set.h"
#include "io/specs/ellipse_query.h"

namespace sturm {

/// The query `document` with some places set (/pointer=value), read.
inline EllipseQuery query_with(Json document, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) apply_set(document, assignment);
  return read_ellipse_query(document, "q.json");
}

/// The message of the InputError that it must throw.
inline std::string query_error_with(const Json& document, const std::vector<std::string>& assignments) {
  return input_error([&] { query_with(document, assignments); });
}

}  // namespace sturm
