#pragma once
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// What a predicted picture is asked for: this similarity with the path-traced one, and to be so many times faster than
/// path tracing to the same error.
inline constexpr double similarity_bar = 0.98, speed_bar = 20.0;

/// One sentence on the similarity and one on the time of an entry of a report's "agreement" and one of its predictions:
/// whether the bar is reached and, where not, what is missing, split into noise of the reference, noise of the
/// prediction and the method, and the parts of the picture where it is. Plain text; empty where the numbers are
/// missing.
std::vector<std::string> agreement_reasons(const Json& entry, const Json& prediction);

/// What the parts of the picture of "causes" are, for readers.
std::string cause_in_words(const std::string& name);

}  // namespace sturm
