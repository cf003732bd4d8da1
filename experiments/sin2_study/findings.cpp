#include <cstdio>
#include <nlohmann/json.hpp>

#include "experiments/sin2_study/sin2_study.h"
#include "io/json/stored.h"
#include "io/json/values.h"

namespace sturm {

namespace {

/// The bound of the gates on closed forms and on wavefront theory, which each mutant must exceed.
constexpr double rounding_bound = 1e-9;

Json mutant(const Json& section, const char* id, const char* what) {
  const auto value = number_at(section, std::string("checks/mutant_") + id + "/value");
  return {{"id", id},
          {"what", what},
          {"failed_as_it_must", value && *value > rounding_bound},
          {"value", number_or_null(value)},
          {"bound", rounding_bound}};
}

/// The row over all views of the real eyes for one model.
const Json& anywhere(const Json& section, const char* model) {
  static const Json none;
  for (const Json& row : array_at(section, "population"))
    if (text_at(row, "ray_model") == model && value_at(row, "accommodation").is_null()) return row;
  return none;
}

}  // namespace

Json sin2_study_mutants(const Json& section) {
  return {
      mutant(section, "repaired_as_sin2",
             "sin² rays got the tangential term that they lack, and were passed off as sin² rays"),
      mutant(section, "wrong_coefficient", "the closed form of sin² was given 4 in place of 5"),
      mutant(section, "mirrored_axis", "wavefront theory was given AXIS 180 − α instead of α; matrix rays were not"),
      mutant(section, "sin2_as_matrix", "sin² rays were passed off as matrix rays")};
}

Json sin2_study_sentence(const Json& section) {
  const auto cases = number_at(section, "checks/cases/value"),
             least = number_at(section, "checks/sin2_error_per_cylinder_min/value"),
             most = number_at(section, "checks/sin2_error_per_cylinder_max/value"),
             repaired = number_at(section, "checks/repaired_vs_theory_max/value");
  if (!cases || !least || !most || !repaired) return nullptr;
  char text[768];
  int used = std::snprintf(
      text, sizeof text,
      "In %.0f traced cases sin² interpolation is exact within each meridian and without a cylinder; with one its blur "
      "is "
      "wrong by %.3f to %.3f D per dioptre of cylinder, and its missing tangential term repairs it to %.1g",
      *cases, *least, *most, *repaired);
  const Json &sin2 = anywhere(section, "sin2_radial"), &printed = anywhere(section, "metalstigmatism");
  if (const auto eyes = number_at(sin2, "eyes"), noticed = number_at(sin2, "noticeable"); eyes && noticed) {
    used += std::snprintf(text + used, sizeof text - static_cast<std::size_t>(used),
                          "; of %.0f real eyes %.0f see an error above 0.25 D at some distance", *eyes, *noticed);
    const auto wrong = number_at(printed, "noticeable"), pole = number_at(printed, "pole");
    if (wrong && pole)
      std::snprintf(text + used, sizeof text - static_cast<std::size_t>(used),
                    ", and by the focal-distance formula as printed %.0f, %.0f more having its pole within the pupil",
                    *wrong, *pole);
  }
  return std::string(text) + ".";
}

}  // namespace sturm
