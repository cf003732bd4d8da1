#include "compare/studies/lens/lens_study_errors.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/studies/lens/lens_study_views.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

template <class T>
void add_new(std::vector<T>& list, const T& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

void raise(WorstError& worst, const std::optional<double>& defocus_D, const std::optional<double>& half_width_arcmin,
           const std::string& view) {
  if (defocus_D && (!worst.defocus_D || *defocus_D > *worst.defocus_D)) {
    worst.defocus_D = defocus_D;
    worst.defocus_view = view;
  }
  if (half_width_arcmin) worst.half_width_arcmin = std::max(*half_width_arcmin, worst.half_width_arcmin.value_or(0.0));
}

}  // namespace

LensStudyErrors::LensStudyErrors(const Json& section) {
  for (const Json& lens : array_at(section, "lenses")) lenses_.push_back(text_at(lens, "id"));
  for (const Json& view : array_at(section, "views")) {
    const auto eccentricity = number_at(view, "eccentricity_deg");
    if (!eccentricity) continue;
    add_new(eccentricities_, *eccentricity);
    for (const Json& pupil : array_at(view, "pupils")) {
      const auto diameter = number_at(pupil, "pupil_mm");
      if (!diameter) continue;
      add_new(pupils_, *diameter);
      for (const StudyMethod& method : study_methods) {
        WorstError& worst = cells_[{text_at(view, "lens"), method.key, *eccentricity, *diameter}];
        const Json& error = value_at(pupil, method.key);
        const auto defocus = number_at(error, "defocus_D");
        if (!defocus) ++worst.without;
        raise(worst, defocus, number_at(error, "half_width_arcmin"), view_name(view));
      }
    }
  }
  std::sort(eccentricities_.begin(), eccentricities_.end());
  std::sort(pupils_.begin(), pupils_.end());
}

WorstError LensStudyErrors::at(const std::string& lens, const std::string& method, double eccentricity_deg,
                               double pupil_mm) const {
  const auto found = cells_.find({lens, method, eccentricity_deg, pupil_mm});
  return found == cells_.end() ? WorstError{} : found->second;
}

WorstError LensStudyErrors::over_gazes(const std::string& lens, const std::string& method, double pupil_mm) const {
  WorstError worst;
  for (const double eccentricity : eccentricities_) {
    const WorstError here = at(lens, method, eccentricity, pupil_mm);
    raise(worst, here.defocus_D, here.half_width_arcmin, here.defocus_view);
    worst.without += here.without;
  }
  return worst;
}

}  // namespace sturm
