#include "compare/findings/sampling_study.h"

#include <cmath>

#include "compare/findings/measured.h"
#include "compare/statistics/statistics.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

constexpr const char* z_unbiased = "|z| of the bias of a spread that should have none";
constexpr const char* z_polar = "z of the bias of uniform_polar";

struct Entry {
  std::string configuration, sampling, sampler, ray_model;

  explicit Entry(const Json& json)
      : configuration(text_at(json, "configuration")),
        sampling(text_at(json, "sampling")),
        sampler(text_at(json, "sampler")),
        ray_model(text_at(json, "ray_model")) {}

  std::string subject() const { return configuration + "|" + sampling + "|" + sampler; }
  /// Through a point it makes no difference where on the pupil; the others are biased by design.
  bool unbiased() const {
    return ray_model == "pinhole" || sampling == "uniform_disk" || sampling == "uniform_polar_weighted";
  }
  Measurement measurement(std::string quantity, const Number& value) const {
    return {.section = "sampling_study",
            .subject = subject(),
            .model = ray_model,
            .quantity = std::move(quantity),
            .value = value};
  }
};

void add_judged(const Entry& entry, const Number& z, Measurements& out) {
  if (entry.unbiased())
    out.push_back(entry.measurement(z_unbiased, z ? Number(std::abs(*z)) : z));
  else if (entry.sampling == "uniform_polar")
    out.push_back(entry.measurement(z_polar, z));
}

void add_compared(const Json& json, const Entry& entry, const Number& degrees, Measurements& out) {
  const std::string name = "sampling " + entry.configuration + ", " + entry.sampling + ", " + entry.sampler + ": ";
  const auto add = [&](const char* key, const std::string& quantity, Better better) {
    Measurement m = entry.measurement(quantity, number_at(json, key));
    m.standard_error = number_at(json, std::string(key) + "_standard_error");
    m.degrees = degrees;
    m.better = better;
    m.run_name = name + quantity;
    out.push_back(std::move(m));
  };
  // Another bias of those that are biased by design is neither better nor worse.
  add("mean_square_bias", "mean square bias [radiance²]", entry.unbiased() ? Better::Nearer : Better::Unknown);
  out.back().target = 0.0;
  add("noise", "noise [radiance]", Better::Less);
}

/// `t_degrees`: z is close to Student's t with so many degrees of freedom (compare/images/paired_bias.h).
void add_row(const Json& json, const Entry& entry, double t_degrees, Measurements& out) {
  Measurement m =
      entry.measurement("RMS bias of the picture ÷ mean radiance, with the sign of its square", std::nullopt);
  const auto square = number_at(json, "mean_square_bias"), radiance = number_at(json, "mean_radiance"),
             t = number_at(json, "z");
  if (square && radiance && *radiance > 0.0) m.value = std::copysign(std::sqrt(std::abs(*square)), *square) / *radiance;
  if (t && t_degrees > 0.0) m.z = normal_equivalent_of_t(*t, t_degrees);
  m.listed_as = m.z ? CaseStatus::Measured : CaseStatus::NoResult;
  out.push_back(std::move(m));
}

}  // namespace

void measure_sampling_study(const Json& report, Measurements& out) {
  const Number replicates = number_at(report, "sampling_study/conditions/replicates");
  // One degree of freedom less than there are pairs of replicates.
  const double t_degrees = replicates ? 0.5 * *replicates * (*replicates - 1.0) - 1.0 : 0.0;
  const Json& entries = array_at(report, "sampling_study/entries");
  const std::size_t first = out.size();
  for (const Json& json : entries) add_row(json, Entry(json), t_degrees, out);
  mark_by_z(std::span(out).subspan(first));
  for (const Json& json : entries) {
    const Entry entry(json);
    add_judged(entry, number_at(json, "z"), out);
    add_compared(json, entry, degrees_of(replicates), out);
  }
}

std::span<const StatisticRule> sampling_study_rules() {
  static constexpr StatisticRule rules[] = {
      {"sampling_unbiased_max_z", "sampling_study", z_unbiased, nullptr},
      {"sampling_raw_polar_min_z", "sampling_study", z_polar, nullptr, Extreme::Of::Smallest},
  };
  return rules;
}

}  // namespace sturm
