#include "compare/findings/agreement.h"

#include "compare/findings/measured.h"
#include "compare/findings/noise_floor.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

constexpr const char* similarity = "SSIM in display space";
constexpr const char* times_faster = "times faster";

/// What gates judge: the whole picture.
void add_judged(const Json& prediction, const std::string& id, Measurements& out) {
  const std::string kind = text_at(prediction, "kind");
  const auto add = [&](const char* quantity, const char* statistic, const Number& value, const Number& error) {
    out.push_back({.section = "agreement",
                   .subject = id,
                   .model = kind,
                   .quantity = quantity,
                   .value = value,
                   .standard_error = error,
                   .statistic = std::string(statistic) + "/" + id + "/" + kind});
  };
  const Number error = number_at(prediction, "parts/0/ssim_display/uncertainty");
  const Number lost = number_at(prediction, "similarity_loss/method");
  add(similarity, "agreement_ssim_display", number_at(prediction, "parts/0/ssim_display/value"), error);
  add("SSIM in display space without noise", "agreement_ssim_without_noise", lost ? Number(1.0 - *lost) : std::nullopt,
      error);
  add(times_faster, "agreement_times_faster", number_at(prediction, "times_faster"), std::nullopt);
  // Of the times nothing says how far they scatter from run to run. There is none where the error is below the
  // reference's noise.
  out.back().better = Better::More;
  out.back().may_vanish = true;
  out.back().run_name = "prediction " + id + ", " + kind + ": times faster";
}

/// What another run of the same experiment has, too: the parts of the picture.
void add_compared(const Json& prediction, const std::string& id, const Number& degrees, Measurements& out) {
  const std::string kind = text_at(prediction, "kind");
  for (const Json& part : array_at(prediction, "parts")) {
    const std::string name = text_at(part, "name");
    const auto add = [&](const char* key, const char* title, Better better) {
      if (const Number value = number_at(part, std::string(key) + "/value"))
        out.push_back({.section = "agreement",
                       .subject = id,
                       .model = kind,
                       .quantity = name + ", " + title,
                       .value = value,
                       .standard_error = number_at(part, std::string(key) + "/uncertainty"),
                       .degrees = degrees,
                       .better = better,
                       .run_name = "prediction " + id + ", " + kind + ", " + name + ": " + title});
    };
    add("ssim_display", "SSIM", Better::More);
    // Not its root: near zero that is neither unbiased nor has it an error that says much.
    add("mean_square_display", "mean square error", Better::Less);
  }
}

void add_row(const Json& prediction, const std::string& id, const Number& floor, Measurements& out) {
  const Number ratio = quotient(number_at(prediction, "parts/0/rmse_display/value"), floor);
  out.push_back({.section = "agreement",
                 .subject = id,
                 .model = text_at(prediction, "kind"),
                 .quantity = "RMSE in display space ÷ noise floor",
                 .value = ratio,
                 .listed_as = !ratio         ? CaseStatus::NoResult
                              : *ratio > 1.0 ? CaseStatus::Differs
                                             : CaseStatus::Agrees});
}

}  // namespace

void measure_agreement(const Json& report, Measurements& out) {
  for (const Json& entry : array_at(report, "agreement")) {
    const std::string id = text_at(entry, "id");
    const Number replicates = number_at(entry, "replicates"), floor = number_at(entry, "noise_floor/rmse_display");
    add_noise_floor(entry, "prediction " + id + ": ", replicates, {.section = "agreement", .subject = id}, out);
    for (const Json& prediction : array_at(entry, "predictions")) {
      add_judged(prediction, id, out);
      add_compared(prediction, id, degrees_of(replicates), out);
      add_row(prediction, id, floor, out);
    }
  }
}

std::span<const StatisticRule> agreement_rules() {
  using Of = Extreme::Of;
  using Per = StatisticRule::Per;
  static constexpr StatisticRule rules[] = {
      {"agreement_ssim_display_min", "agreement", similarity, nullptr, Of::Smallest, true, Per::Model},
      {"agreement_times_faster_min", "agreement", times_faster, nullptr, Of::Smallest, false, Per::Model},
  };
  return rules;
}

}  // namespace sturm
