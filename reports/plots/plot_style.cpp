#include "reports/plots/plot_style.h"

#include <cmath>

#include "io/files/formatted_text.h"

namespace sturm {

std::string plot_string(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'')
      quoted += "''";
    else if (c == '\n' || c == '\r')
      quoted += ' ';
    else if (std::string_view("{}_^@&~\\").find(c) != std::string_view::npos)
      quoted.append("\\").append(1, c);
    else
      quoted += c;
  }
  return quoted + "'";
}

std::string data_block(const std::string& name, const std::string& rows) {
  return "$" + name + " << END\n" + rows + "END\n";
}

std::string distance_words(double distance_m) {
  if (std::isinf(distance_m)) return "far away";
  return distance_m < 1.0 ? plain_number(100.0 * distance_m, 3) + " cm" : plain_number(distance_m, 3) + " m";
}

}  // namespace sturm
