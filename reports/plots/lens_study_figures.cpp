#include "reports/plots/lens_study_figures.h"

#include "reports/plots/lens_convergence_figure.h"
#include "reports/plots/lens_field_figures.h"
#include "reports/plots/lens_heat_map.h"

namespace sturm {

std::vector<Figure> lens_study_figures(const LensFindings& found) {
  std::vector<Figure> figures;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) figures.push_back(std::move(*figure));
  };
  add(convergence_figure(found));
  if (found.field) {
    add(field_curves(*found.field));
    add(field_ellipses(*found.field));
  }
  const LensStudyErrors errors(found);
  for (const std::string& lens : errors.lenses()) figures.push_back(heat_map(errors, lens));
  return figures;
}

}  // namespace sturm
