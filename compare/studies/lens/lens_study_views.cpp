#include "compare/studies/lens/lens_study_views.h"

#include "io/files/formatted_text.h"

namespace sturm {

std::set<std::string> spline_lenses(const LensFindings& found) {
  std::set<std::string> ids;
  for (const LensFacts& lens : found.lenses)
    if (!lens.analytic_surfaces.value_or(true)) ids.insert(lens.id);
  return ids;
}

std::string view_name(const LensStudyView& view) {
  const auto text = [](const Number& value) { return value ? plain_number(*value) : std::string("–"); };
  std::string name = view.lens + "|" + text(view.eccentricity_deg) + "°";
  if (view.direction_deg) name += " " + text(view.direction_deg) + "°";
  const bool infinite = view.distance_m && view.distance_m->is_infinite();
  return name + "|" + (infinite ? "inf" : text(view.finite_distance_m()) + " m");
}

}  // namespace sturm
