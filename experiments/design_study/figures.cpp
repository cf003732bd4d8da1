#include <algorithm>

#include "experiments/design_study/design_study.h"
#include "experiments/figures/lens_maps.h"
#include "experiments/figures/lens_plots.h"
#include "io/files/formatted_text.h"
#include "reports/plots/plot_style.h"
#include "reports/plots/wearers_plot.h"

namespace sturm {

namespace {

Figure figure(const std::string& id, const std::string& title, const std::string& caption, const Plot& plot) {
  return {.id = "design_study_" + id,
          .section = "design_study",
          .title = title,
          .caption = caption,
          .command = "",
          .svg = gnuplot_labelled_file(plot.script, plot.frame)};
}

std::vector<NamedLens> lenses_of(const DesignStudySpec& study, bool progressive_only) {
  std::vector<NamedLens> lenses;
  for (const StudyDesign& design : study.designs)
    if (!progressive_only || design.document.contains("progressive"))
      lenses.push_back({design.id, *design.made.lens, nominal_power(design.made, {design.file, ""})});
  return lenses;
}

/// The eyes that the designs correct, behind them.
std::vector<NamedEye> eyes_of(const DesignStudySpec& study) {
  std::vector<NamedEye> eyes;
  for (const NamedLens& lens : lenses_of(study, false)) {
    Prescription rx = lens.nominal.as_prescription();
    rx.vertex_distance_m = lens.lens.vertex_distance_m;
    WornEye worn;
    worn.eye = Eye::with(rx, study.pupil_diameter_m, BestAccommodation{study.amplitude_D});
    worn.eye.rotation_center_m = study.rotation_center_m;
    worn.spectacles = lens.lens;
    eyes.push_back({lens.name, worn});
  }
  return eyes;
}

std::vector<SharesAtDistance> shares_of(const DesignStudySpec& study, const DesignFindings& found) {
  std::vector<SharesAtDistance> distances;
  for (const double distance : study.distances_m) {
    SharesAtDistance at{distance, {}};
    for (const StudyDesign& design : study.designs) {
      BlurredShares shares{design.id, {}};
      for (const DesignWearer& row : found.wearers)
        if (row.design == design.id && row.distance_m == StoredDistance{distance} && row.share_blurred)
          shares.shares.push_back(*row.share_blurred);
      at.designs.push_back(std::move(shares));
    }
    distances.push_back(std::move(at));
  }
  return distances;
}

}  // namespace

std::vector<Figure> design_figures(const DesignStudySpec& study, const DesignFindings& found) {
  const std::vector<NamedLens> lenses = lenses_of(study, false), progressive = lenses_of(study, true);
  std::vector<Figure> figures{figure("maps", "What each design gives more than it was made for, as worn",
                                     "Mean power above, cylinder below. Red is too much power.",
                                     power_plot(lenses, study.rotation_center_m, false, study.range_D))};
  if (lenses.size() > 1)
    figures.push_back(figure("difference", "What each further design has more than " + lenses[0].name,
                             "At the places of " + lenses[0].name +
                                 " through which the same lines of sight go. Red: the further design has more power.",
                             difference_plot(lenses, study.rotation_center_m, study.range_D)));
  if (!progressive.empty())
    figures.push_back(figure("corridor", "Along the line of least cylinder",
                             "By the elevation of the gaze. The width is that of less than 0.5 D of cylinder.",
                             corridor_plot(corridor_profiles(progressive, study.rotation_center_m))));
  const std::vector<NamedEye> eyes = eyes_of(study);
  for (std::size_t i = 0; i < study.distances_m.size(); ++i)
    figures.push_back(figure(
        "ellipses_" + std::to_string(i + 1), "Blur ellipses, target " + distance_words(study.distances_m[i]),
        "Of the eye that each design corrects, which accommodates by up to " + plain_number(study.amplitude_D) + " D.",
        fields_plot(eyes, {study.distances_m[i]}, study.clear_D, std::nullopt)));
  if (study.population)
    figures.push_back(figure("wearers", "How many wearers have how many blurred gazes",
                             "The higher the curve, the more of the wearers see clearly in most directions.",
                             wearers_plot(shares_of(study, found), study.clear_D)));
  return figures;
}

}  // namespace sturm
