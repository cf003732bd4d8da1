#pragma once
#include <string>

namespace sturm {

/// The distance [m] that an option states: 0.001 … 1e6, or "inf". Throws InputError.
double distance_option(const std::string& text, const char* option);

}  // namespace sturm
