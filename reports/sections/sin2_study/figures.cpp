#include "reports/sections/sin2_study/figures.h"

namespace sturm {

std::vector<Figure> sin2_study_figures(const Json& section, const std::filesystem::path& run_folder) {
  std::vector<Figure> figures;
  for (std::optional<Figure> figure : {sin2_error_map(section), sin2_gallery(section, run_folder),
                                       sin2_population_curves(section), sin2_sphere_curves(section)})
    if (figure) figures.push_back(std::move(*figure));
  return figures;
}

}  // namespace sturm
