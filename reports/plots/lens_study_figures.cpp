#include "reports/plots/lens_study_figures.h"

#include "io/json/stored.h"
#include "reports/plots/lens_convergence_figure.h"
#include "reports/plots/lens_field_figures.h"
#include "reports/plots/lens_heat_map.h"

namespace sturm {

std::vector<Figure> lens_study_figures(const Json& section) {
  std::vector<Figure> figures;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) figures.push_back(std::move(*figure));
  };
  add(convergence_figure(section));
  add(field_curves(value_at(section, "field")));
  add(field_ellipses(value_at(section, "field")));
  const LensStudyErrors errors(section);
  for (const std::string& lens : errors.lenses()) figures.push_back(heat_map(errors, lens));
  return figures;
}

}  // namespace sturm
