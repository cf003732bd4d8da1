#include <cstdio>
#include <nlohmann/json.hpp>

#include "experiments/sin2_study/sin2_study.h"
#include "io/json/values.h"

namespace sturm {

namespace {

/// The bound of the gates on closed forms and on wavefront theory, which each mutant must exceed.
constexpr double rounding_bound = 1e-9;

Number value_of(const Sin2StudyFindings& found, const std::string& check) {
  const Sin2Check* of_name = found.check(check);
  return of_name ? of_name->value : std::nullopt;
}

Json mutant(const Sin2StudyFindings& found, const char* id, const char* what) {
  const Number value = value_of(found, std::string("mutant_") + id);
  return {{"id", id},
          {"what", what},
          {"failed_as_it_must", value && *value > rounding_bound},
          {"value", number_or_null(value)},
          {"bound", rounding_bound}};
}

/// The row over each eye's worst view, without numbers if there is none.
Sin2PopulationRow worst_views(const Sin2StudyFindings& found, RayModel model) {
  const Sin2PopulationRow* row = found.worst_views(model);
  return row ? *row : Sin2PopulationRow{};
}

}  // namespace

Json sin2_study_mutants(const Sin2StudyFindings& found) {
  return {mutant(found, "repaired_as_sin2",
                 "sin² rays got the tangential term that they lack, and were passed off as sin² rays"),
          mutant(found, "wrong_coefficient", "the closed form of sin² was given 4 in place of 5"),
          mutant(found, "mirrored_axis", "wavefront theory was given AXIS 180 − α instead of α; matrix rays were not"),
          mutant(found, "sin2_as_matrix", "sin² rays were passed off as matrix rays")};
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
