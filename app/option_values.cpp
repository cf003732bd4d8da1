#include "app/option_values.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "lensmodel/accommodation.h"

namespace sturm {

namespace {

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

std::optional<double> number(std::string_view text) {
  text = without_blanks(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

double distance_option(const std::string& text, const char* option) {
  const std::string word = lower_case(without_blanks(text));
  if (word == "inf" || word == "infinity" || word == "∞") return std::numeric_limits<double>::infinity();
  const std::optional<double> value = number(text);
  if (!value || !(*value >= 1e-3 && *value <= 1e6))
    throw InputError("", option, "\"" + text + "\"", "a distance from 0.001 to 1e6 in metres, like 0.4, or inf");
  return *value;
}

double amplitude_option(const std::optional<double>& age_years, const std::optional<double>& amplitude_D) {
  return age_years ? hofstetter_amplitude(*age_years) : amplitude_D.value_or(0.0);
}

std::array<double, 2> pair_option(const std::string& text, char mark, const char* option, const std::string& expected) {
  const std::size_t at = std::min(text.find(mark), text.size());
  const std::optional<double> first = number(std::string_view(text).substr(0, at)),
                              second = number(std::string_view(text).substr(std::min(at + 1, text.size())));
  if (!first || !second) throw InputError("", option, "\"" + text + "\"", expected);
  return {*first, *second};
}

}  // namespace sturm
