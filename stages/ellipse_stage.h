#pragma once
#include "io/ellipse_query.h"
#include "io/json.h"

namespace sturm {

/// Answers a sturm.ellipse/1 query: a sturm.ellipse_result/1 document, one result per target and method.
Json blur_ellipses(const EllipseQuery& query);

}  // namespace sturm
