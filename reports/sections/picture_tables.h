#pragma once
#include <vector>

#include "compare/findings/pictures.h"
#include "reports/markup/html.h"

namespace sturm {

/// Metrics of whole pictures, a row for each finding.
Html picture_metrics_table(const std::vector<PictureFinding>& pictures);

/// Predictions and what they are worth, a row for each prediction.
Html prediction_table(const std::vector<PictureFinding>& pictures);

/// What the report finds of each prediction of a view against its bars, with what is missing, and its errors by region.
/// Nothing of a view that was not measured by region.
Html prediction_details(const PictureFinding& view);

}  // namespace sturm
