#pragma once
#include <array>
#include <optional>
#include <string>

namespace sturm {

/// A distance on the command line [m]: 0.001 … 1e6, or "inf" (also "infinity", "∞"). Throws InputError that names the
/// option.
double distance_option(const std::string& text, const char* option);

/// The amplitude of accommodation [D] of an age, or as stated; 0 where neither is given.
double amplitude_option(const std::optional<double>& age_years, const std::optional<double>& amplitude_D);

/// Two numbers with a mark between them: "20,-10", "480x320". Throws InputError that names the option and says what was
/// expected.
std::array<double, 2> pair_option(const std::string& text, char mark, const char* option, const std::string& expected);

}  // namespace sturm
