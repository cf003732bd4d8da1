#pragma once
#include <string>
#include <vector>

#include "compare/findings/pictures.h"

namespace sturm {

/// What a predicted picture is asked for: this similarity with the path-traced one, and to be so many times faster than
/// path tracing to the same error.
inline constexpr double similarity_bar = 0.98, speed_bar = 20.0;

/// One sentence on the similarity and one on the time of one of the predictions of a view that was measured by region:
/// whether the bar is reached and, where not, what is missing, split into noise of the reference, noise of the
/// prediction and the method, and the parts of the picture where it is. Plain text; empty where the numbers are
/// missing.
std::vector<std::string> prediction_reasons(const PictureFinding& view, const PredictionFinding& prediction);

/// What the parts of the picture of PredictionFinding::causes are, for readers.
std::string cause_in_words(const std::string& name);

}  // namespace sturm
