#pragma once
#include "io/json/json.h"
#include "io/specs/ellipse_query.h"

namespace sturm {

/// Answers a sturm.ellipse/1 query: a sturm.ellipse_result/1 document, one result per target and method.
Json blur_ellipses(const EllipseQuery& query);

}  // namespace sturm
