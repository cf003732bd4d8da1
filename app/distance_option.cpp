#include "app/distance_option.h"

#include <charconv>
#include <limits>

#include "io/files/error.h"

namespace sturm {

double distance_option(const std::string& text, const char* option) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !(value >= 1e-3 && value <= 1e6))
    throw InputError("", option, "\"" + text + "\"", "a distance from 0.001 to 1e6 m, or inf");
  return value;
}

}  // namespace sturm
