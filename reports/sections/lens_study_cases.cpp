#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "compare/studies/lens/lens_study_errors.h"
#include "compare/studies/lens/lens_study_statistics.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "reports/sections/cases.h"

namespace sturm {

namespace {

/// The views of one lens at all pupils, by one method.
struct Tally {
  std::optional<double> worst_D;
  std::string where;
  std::size_t ellipses = 0, matter = 0, without = 0;
};

void add(const Json& view, const Json& pupil, const char* method, Tally& tally) {
  const auto error = number_at(pupil, std::string(method) + "/defocus_D");
  if (!error) {
    ++tally.without;
    return;
  }
  ++tally.ellipses;
  if (*error > defocus_that_matters_D) ++tally.matter;
  if (tally.worst_D && *error <= *tally.worst_D) return;
  tally.worst_D = error;
  const std::string name = view_name(view);
  const auto diameter = number_at(pupil, "pupil_mm");
  tally.where = name.substr(std::min(name.size(), text_at(view, "lens").size() + 1)) +
                (diameter ? ", pupil " + plain_number(*diameter) + " mm" : std::string());
}

std::string measure_of(const Tally& tally) {
  std::string text = "largest error from real rays [D]";
  if (!tally.where.empty()) text += " (" + tally.where + ")";
  text += "; above " + plain_number(defocus_that_matters_D) + " D in " + std::to_string(tally.matter) + " of " +
          std::to_string(tally.ellipses) + " views and pupils";
  return tally.without > 0 ? text + "; none in " + std::to_string(tally.without) : text;
}

}  // namespace

void add_lens_study_cases(const Json& report, std::vector<ReportCase>& cases) {
  std::map<std::pair<std::string, std::string>, Tally> tallies;
  for (const Json& view : array_at(report, "lens_study/views"))
    for (const Json& pupil : array_at(view, "pupils"))
      for (const StudyMethod& method : study_methods)
        add(view, pupil, method.key, tallies[{text_at(view, "lens"), method.key}]);
  for (const Json& lens : array_at(report, "lens_study/lenses"))
    for (const StudyMethod& method : study_methods) {
      const Tally& tally = tallies[{text_at(lens, "id"), method.key}];
      const CaseStatus status = !tally.worst_D                            ? CaseStatus::NoResult
                                : *tally.worst_D > defocus_that_matters_D ? CaseStatus::Differs
                                                                          : CaseStatus::Agrees;
      cases.push_back(
          {"lens_study", text_at(lens, "id"), method.key, measure_of(tally), tally.worst_D, std::nullopt, status});
    }
}

}  // namespace sturm
