#include "compare/studies/agreement/agreement_statistics.h"

#include <map>
#include <nlohmann/json.hpp>

#include "compare/gates/extreme_statistic.h"
#include "io/json/stored.h"

namespace sturm {

void add_agreement_statistics(const Json& report, Statistics& out) {
  std::map<std::string, Extreme> similar, fast;
  for (const Json& entry : array_at(report, "agreement"))
    for (const Json& prediction : array_at(entry, "predictions")) {
      const std::string id = text_at(entry, "id"), kind = text_at(prediction, "kind");
      const auto ssim = number_at(prediction, "parts/0/ssim_display/value"),
                 error = number_at(prediction, "parts/0/ssim_display/uncertainty");
      const auto times = number_at(prediction, "times_faster");
      out["agreement_ssim_display/" + id + "/" + kind] = {ssim, error, 1, id};
      const auto method = number_at(prediction, "similarity_loss/method");
      out["agreement_ssim_without_noise/" + id + "/" + kind] = {method ? Number(1.0 - *method) : std::nullopt, error, 1,
                                                                id};
      out["agreement_times_faster/" + id + "/" + kind] = {times, std::nullopt, 1, id};
      similar.try_emplace(kind, Extreme::Of::Smallest).first->second.add(ssim, id, error);
      fast.try_emplace(kind, Extreme::Of::Smallest).first->second.add(times, id);
    }
  for (const auto& [kind, extreme] : similar) out["agreement_ssim_display_min/" + kind] = extreme.result();
  for (const auto& [kind, extreme] : fast) out["agreement_times_faster_min/" + kind] = extreme.result();
}

}  // namespace sturm
