#include "reports/plots/ellipse_outline.h"

#include <cmath>

#include "io/files/formatted_text.h"
#include "lensmodel/units.h"

namespace sturm {

std::string ellipse_outline(const Ellipse& ellipse, const Eigen::Vector2d& centre, double scale) {
  constexpr int corners = 60;
  const auto [sine, cosine] = sine_cosine_of_degrees(ellipse.orientation_deg.value_or(0.0));
  std::string rows;
  for (int i = 0; i <= corners; ++i) {
    const auto [y, x] = sine_cosine_of_degrees(360.0 / corners * i);
    const double along = scale * ellipse.semi_major * x, across = scale * ellipse.semi_minor * y;
    rows += plain_number(centre.x() + along * cosine - across * sine, 7) + " " +
            plain_number(centre.y() + along * sine + across * cosine, 7) + "\n";
  }
  return rows + "\n";
}

}  // namespace sturm
