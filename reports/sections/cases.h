#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm {

/// Chance of any false alarm among all cases of one kind together.
inline constexpr double case_family_level = 0.01;

/// In reading order.
enum class CaseStatus { Failed, NoResult, Differs, Agrees, Measured };

/// One row of the report's table of cases.
struct ReportCase {
  std::string section;  ///< id of the page's section that tells more
  std::string id;
  std::string ray_model;  ///< or kind of prediction, or method
  std::string measure;    ///< plain text
  std::optional<double> value, z{};
  CaseStatus status = CaseStatus::Measured;
};

/// Views path traced and predicted: error over the path tracer's own noise floor.
void add_agreement_cases(const Json& report, std::vector<ReportCase>& cases);

/// Spreads of rays over the pupil: bias, told from noise by its z at the family-wise level.
void add_sampling_cases(const Json& report, std::vector<ReportCase>& cases);

/// The study of sin²: its checks, each with the case that decided, and the point spreads of its gallery over their own
/// noise floor.
void add_sin2_study_cases(const Json& report, std::vector<ReportCase>& cases);

/// The study of spectacles: per lens and method the largest error against real rays over all its views and pupils, and
/// in how many of them it matters to a wearer.
void add_lens_study_cases(const Json& report, std::vector<ReportCase>& cases);

/// Whether the failed gate `gate` names this case as the one that decided. Its statistic says which section and ray
/// model it is about.
bool decided(const Json& gate, const ReportCase& item);

}  // namespace sturm
