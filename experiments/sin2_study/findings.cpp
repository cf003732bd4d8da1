#include <cstdio>
#include <nlohmann/json.hpp>

#include "experiments/sin2_study/sin2_study.h"

namespace sturm {

namespace {

constexpr OwnMutation mutations[] = {
    {"repaired_as_sin2", "sin² rays get the tangential term that they lack, and are passed off as sin² rays"},
    {"wrong_coefficient", "the closed form of sin² is given 4 in place of 5"},
    {"mirrored_axis", "wavefront theory is given AXIS 180 − α instead of α; matrix rays are not"},
    {"sin2_as_matrix", "sin² rays are passed off as matrix rays"}};

/// The check that a mutation makes wrong, in the order of the mutations.
constexpr const char* checks_of_mutations[] = {"sin2_vs_closed_form_max", "sin2_vs_closed_form_max",
                                               "matrix_vs_theory_max", "matrix_vs_theory_max"};

Number value_of(const Sin2StudyFindings& found, const std::string& check) {
  const Sin2Check* of_name = found.check(check);
  return of_name ? of_name->value : std::nullopt;
}

/// The row over each eye's worst view, without numbers if there is none.
Sin2PopulationRow worst_views(const Sin2StudyFindings& found, RayModel model) {
  const Sin2PopulationRow* row = found.worst_views(model);
  return row ? *row : Sin2PopulationRow{};
}

}  // namespace

std::span<const OwnMutation> sin2_study_mutations() {
  return mutations;
}

Sin2StudyFindings mutated_sin2_study(Sin2StudyFindings found, const std::string& mutation) {
  for (std::size_t i = 0; i < std::size(mutations); ++i)
    if (mutation == mutations[i].id)
      if (const Sin2Check* wrong = found.check("mutant_" + mutation)) found.checks[checks_of_mutations[i]] = *wrong;
  return found;
}

Json sin2_study_sentence(const Sin2StudyFindings& found) {
  const Number cases = value_of(found, "cases"), least = value_of(found, "sin2_error_per_cylinder_min"),
               most = value_of(found, "sin2_error_per_cylinder_max"),
               repaired = value_of(found, "repaired_vs_theory_max");
  if (!cases || !least || !most || !repaired) return nullptr;
  char text[768];
  int used = std::snprintf(
      text, sizeof text,
      "In %.0f traced cases sin² interpolation is exact within each meridian and without a cylinder; with one its blur "
      "is "
      "wrong by %.3f to %.3f D per dioptre of cylinder, and its missing tangential term repairs it to %.1g",
      *cases, *least, *most, *repaired);
  const Sin2PopulationRow sin2 = worst_views(found, RayModel::sin2_radial),
                          printed = worst_views(found, RayModel::metalstigmatism);
  if (const Number eyes = sin2.eyes, noticed = sin2.noticeable; eyes && noticed) {
    used += std::snprintf(text + used, sizeof text - static_cast<std::size_t>(used),
                          "; of %.0f real eyes %.0f see an error above 0.25 D at some distance", *eyes, *noticed);
    const Number wrong = printed.noticeable, pole = printed.pole;
    if (wrong && pole)
      std::snprintf(text + used, sizeof text - static_cast<std::size_t>(used),
                    ", and by the focal-distance formula as printed %.0f, %.0f more having its pole within the pupil",
                    *wrong, *pole);
  }
  return std::string(text) + ".";
}

}  // namespace sturm
