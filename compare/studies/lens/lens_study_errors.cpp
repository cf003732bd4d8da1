#include "compare/studies/lens/lens_study_errors.h"

#include <algorithm>

#include "compare/studies/lens/lens_study_views.h"

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

LensStudyErrors::LensStudyErrors(const LensFindings& found) {
  for (const LensFacts& lens : found.lenses) lenses_.push_back(lens.id);
  for (const LensStudyView& view : found.views) {
    if (!view.eccentricity_deg) continue;
    add_new(eccentricities_, *view.eccentricity_deg);
    for (const LensPupil& pupil : view.pupils) {
      if (!pupil.pupil_mm) continue;
      add_new(pupils_, *pupil.pupil_mm);
      for (const StudyMethod& method : study_methods) {
        WorstError& worst = cells_[{view.lens, method.key, *view.eccentricity_deg, *pupil.pupil_mm}];
        const std::optional<MethodError>& error = pupil.*method.error;
        if (!defocus_of(error)) ++worst.without;
        if (error) raise(worst, error->defocus_D, error->half_width_arcmin, view_name(view));
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
