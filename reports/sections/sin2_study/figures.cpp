#include "reports/sections/sin2_study/figures.h"

namespace sturm {

std::vector<Figure> sin2_study_figures(const Sin2StudyFindings& found, const std::filesystem::path& run_folder) {
  std::vector<Figure> figures;
  for (std::optional<Figure> figure : {sin2_error_map(found), sin2_gallery(found, run_folder),
                                       sin2_population_curves(found), sin2_sphere_curves(found)})
    if (figure) figures.push_back(std::move(*figure));
  return figures;
}

}  // namespace sturm
