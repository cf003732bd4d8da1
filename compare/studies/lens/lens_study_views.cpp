#include "compare/studies/lens/lens_study_views.h"

#include <nlohmann/json.hpp>
#include <set>

#include "io/files/formatted_text.h"
#include "io/json/stored.h"

namespace sturm {

std::set<std::string> spline_lenses(const Json& section) {
  std::set<std::string> ids;
  for (const Json& lens : array_at(section, "lenses"))
    if (!boolean_at(lens, "analytic_surfaces").value_or(true)) ids.insert(text_at(lens, "id"));
  return ids;
}

std::string view_name(const Json& view) {
  const auto number = [&](const char* path) {
    const auto value = number_at(view, path);
    return value ? plain_number(*value) : std::string("–");
  };
  std::string name = text_at(view, "lens") + "|" + number("eccentricity_deg") + "°";
  if (number_at(view, "direction_deg")) name += " " + number("direction_deg") + "°";
  return name + "|" + (value_at(view, "distance_m") == "inf" ? "inf" : number("distance_m") + " m");
}

}  // namespace sturm
