#include <cmath>

#include "compare/statistics/statistics.h"
#include "compare/statistics/test_family.h"
#include "compare/studies/sin2/shown_checks.h"
#include "io/json/stored.h"
#include "reports/sections/cases.h"

namespace sturm {

namespace {

using Status = CaseStatus;

/// Total variation of two runs of one pattern over that of two others: between the seeds 1 … 6 and six views it
/// scatters from 0.90 to 1.21 (configs/gates/sin2_study.json), and patterns that are really others have above 100.
constexpr double same_pattern = 1.5;

/// What a gate's statistic is about: the section, and the model or kind ("": any).
struct Subject {
  std::string section, model;
};

Subject subject_of(const std::string& statistic) {
  const auto starts = [&](const char* word) { return statistic.starts_with(word); };
  const auto about = [&](const char* word) { return statistic.find(word) != std::string::npos; };
  if (starts("agreement_")) return {"agreement", statistic.substr(statistic.rfind('/') + 1)};
  if (starts("sampling_")) return {"sampling_study", ""};
  if (starts("sin2_study/gallery_")) return {"sin2_study", about("repaired") ? "repaired" : "sin2_radial"};
  if (starts("lens_"))
    return {"lens_study", about("published") ? "published" : about("previous") ? "previous" : "ray_transfer"};
  if (starts("sin2_study/")) return {"sin2_study", ""};
  const std::string model = about("thin_lens")                  ? "thin_lens"
                            : about("sin2") && !about("matrix") ? "sin2_radial"
                                                                : "power_matrix";
  return {starts("psf_") ? "psfs" : starts("image_") ? "images" : "ellipses", model};
}

}  // namespace

bool decided(const Json& gate, const ReportCase& item) {
  if (boolean_at(gate, "passed").value_or(false)) return false;
  const std::string statistic = text_at(gate, "statistic"), worst = text_at(gate, "worst_case");
  const Subject subject = subject_of(statistic);
  if (item.section != subject.section || (!subject.model.empty() && item.ray_model != subject.model)) return false;
  if (item.section == "lens_study" && worst.starts_with(item.id + "|")) return true;  // a view of the lens
  return worst == item.id || worst.starts_with(item.id + ",") || statistic == "sin2_study/" + item.id;
}

void add_agreement_cases(const Json& report, std::vector<ReportCase>& cases) {
  for (const Json& entry : array_at(report, "agreement")) {
    const auto floor = number_at(entry, "noise_floor/rmse_display");
    for (const Json& prediction : array_at(entry, "predictions")) {
      const auto error = number_at(prediction, "parts/0/rmse_display/value");
      std::optional<double> ratio;
      if (error && floor && *floor > 0.0) ratio = *error / *floor;
      const Status status = !ratio ? Status::NoResult : *ratio > 1.0 ? Status::Differs : Status::Agrees;
      cases.push_back({"agreement", text_at(entry, "id"), text_at(prediction, "kind"),
                       "RMSE in display space ÷ noise floor", ratio, std::nullopt, status});
    }
  }
}

void add_sampling_cases(const Json& report, std::vector<ReportCase>& cases) {
  const auto replicates = number_at(report, "sampling_study/conditions/replicates");
  // z is close to Student's t with one degree of freedom less than there are pairs of replicates
  // (compare/images/paired_bias.h).
  const double degrees = replicates ? 0.5 * *replicates * (*replicates - 1.0) - 1.0 : 0.0;
  TestFamily family(case_family_level);
  const std::size_t first = cases.size();
  for (const Json& entry : array_at(report, "sampling_study/entries")) {
    const auto square = number_at(entry, "mean_square_bias"), radiance = number_at(entry, "mean_radiance"),
               t = number_at(entry, "z");
    ReportCase item{
        "sampling_study",
        text_at(entry, "configuration") + "|" + text_at(entry, "sampling") + "|" + text_at(entry, "sampler"),
        text_at(entry, "ray_model"), "RMS bias of the picture ÷ mean radiance, with the sign of its square",
        std::nullopt};
    if (square && radiance && *radiance > 0.0)
      item.value = std::copysign(std::sqrt(std::abs(*square)), *square) / *radiance;
    if (t && degrees > 0.0) item.z = normal_equivalent_of_t(*t, degrees);
    item.status = item.z ? Status::Measured : Status::NoResult;
    if (item.z) family.add(item.id, *item.z);
    cases.push_back(std::move(item));
  }
  const double threshold = family.two_sided_threshold();
  for (std::size_t i = first; i < cases.size(); ++i)
    if (cases[i].z) cases[i].status = std::abs(*cases[i].z) > threshold ? Status::Differs : Status::Agrees;
}

void add_sin2_study_cases(const Json& report, std::vector<ReportCase>& cases) {
  for (const ShownCheck& check : shown_checks) {
    const Json& entry = value_at(report, std::string("sin2_study/checks/") + check.key);
    if (!entry.is_object()) continue;
    const std::string worst = text_at(entry, "worst_case");
    const std::size_t model = worst.rfind('|');
    const auto value = number_at(entry, "value");
    cases.push_back({"sin2_study", check.key, model == std::string::npos ? "" : worst.substr(model + 1),
                     std::string(check.what) + (worst.empty() ? "" : ", decided by " + worst), value, std::nullopt,
                     value ? Status::Measured : Status::NoResult});
  }
  for (const Json& view : array_at(report, "sin2_study/gallery"))
    for (const Json& psf : array_at(view, "models")) {
      if (text_at(psf, "model") == "wavefront") continue;  // theory itself
      const auto ratio = number_at(psf, "total_variation_over_noise");
      const Status status = !ratio ? Status::NoResult : *ratio > same_pattern ? Status::Differs : Status::Agrees;
      cases.push_back({"sin2_study", text_at(view, "id"), text_at(psf, "model"),
                       "total variation of the point spread from theory's ÷ that of two runs of theory", ratio,
                       std::nullopt, status});
    }
}

}  // namespace sturm
