#include "compare/findings/depth_psf_study.h"

#include <map>
#include <utility>

#include "compare/gates/extreme_statistic.h"
#include "compare/studies/depth_psf/depth_psf_findings.h"
#include "io/files/formatted_text.h"

namespace sturm {

namespace {

constexpr const char* section = "depth_psf_study";
constexpr double rounding_of_spreads =
    1e-6;  // of other compilers and machines: of all numbers here at most a millionth

std::string text_of(const Number& number) {
  return number ? plain_number(*number) : "?";
}

std::string text_of(const Count& count) {
  return count ? std::to_string(*count) : "?";
}

void add(const std::string& subject, const std::string& quantity, const std::string& statistic, const Number& value,
         Measurements& out) {
  out.push_back({.section = section,
                 .subject = subject,
                 .quantity = quantity,
                 .value = value,
                 .bound = rounding_of_spreads,
                 .better = Better::Less,
                 .statistic = section + ("/" + statistic),
                 .run_name = "point spreads over depth, " + subject + ": " + quantity,
                 .listed_as = value ? CaseStatus::Measured : CaseStatus::NoResult});
}

void add_map(const std::vector<SpreadCell>& map, Measurements& out) {
  std::map<std::pair<std::string, double>, Extreme> largest;
  for (const SpreadCell& cell : map)
    largest[{cell.light, cell.pupil_mm.value_or(0.0)}].add(cell.total_variation, text_of(cell.defocus_D) + " D");
  for (const auto& [of, extreme] : largest) {
    const auto& [light, pupil_mm] = of;
    add(light + ", pupil " + plain_number(pupil_mm) + " mm", "largest total variation between rays and waves",
        "map/" + light + "/" + plain_number(pupil_mm), extreme.result().value, out);
    out.back().cases = extreme.result().cases;
    out.back().worst_case = extreme.result().worst_case;
  }
}

void add_eyes(const EyesBeyond& eyes, Measurements& out) {
  const std::string statistic = "eyes/" + eyes.id;
  add(eyes.id, "median defocus of what lies beyond second order [D]", statistic + "/median_D", eyes.defocus_D[1], out);
  add(eyes.id, "share of the eyes with more than a lens step beyond second order", statistic + "/share_above_step",
      eyes.share_above_step, out);
}

void add_banding(const BandingRow& row, Measurements& out) {
  const std::string subject = row.weights + " weights, " + text_of(row.pupil_parts) + " part(s), planes " +
                              text_of(row.spacing_px) + " px apart";
  const std::string statistic =
      "banding/" + row.weights + "/" + text_of(row.pupil_parts) + "/" + text_of(row.spacing_px);
  add(subject, "RMSE of a slanted surface", statistic + "/rmse", row.rmse, out);
  add(subject, "largest false step of a slanted surface", statistic + "/step", row.largest_step, out);
}

}  // namespace

void measure_depth_psf_study(const Json& report, Measurements& out) {
  const DepthPsfFindings found = depth_psf_findings(report).value_or(DepthPsfFindings{});
  add_map(found.map, out);
  for (const EyesBeyond& eyes : found.eyes) add_eyes(eyes, out);
  for (const BandingRow& row : found.banding) add_banding(row, out);
}

}  // namespace sturm
