#include "compare/findings/sampling_study.h"

#include <cmath>

#include "compare/findings/measured.h"
#include "compare/statistics/statistics.h"
#include "compare/studies/samplings/sampling_findings.h"
#include "compare/studies/stored_words.h"

namespace sturm {

namespace {

constexpr const char* z_unbiased = "|z| of the bias of a spread that should have none";
constexpr const char* z_polar = "z of the bias of uniform_polar";

std::string subject_of(const SamplingEntry& entry) {
  return entry.configuration + "|" + word_of(entry.sampling) + "|" + word_of(entry.sampler);
}

Measurement measurement_of(const SamplingEntry& entry, std::string quantity, const Number& value) {
  return {.section = "sampling_study",
          .subject = subject_of(entry),
          .model = word_of(entry.ray_model),
          .quantity = std::move(quantity),
          .value = value};
}

void add_judged(const SamplingEntry& entry, Measurements& out) {
  if (entry.should_be_unbiased())
    out.push_back(measurement_of(entry, z_unbiased, entry.z ? Number(std::abs(*entry.z)) : std::nullopt));
  else if (entry.sampling == PupilSampling::UniformPolar)
    out.push_back(measurement_of(entry, z_polar, entry.z));
}

void add_compared(const SamplingEntry& entry, const Number& degrees, Measurements& out) {
  const std::string name =
      "sampling " + entry.configuration + ", " + word_of(entry.sampling) + ", " + word_of(entry.sampler) + ": ";
  const auto add = [&](const std::string& quantity, const Number& value, const Number& error, Better better) {
    Measurement m = measurement_of(entry, quantity, value);
    m.standard_error = error;
    m.degrees = degrees;
    m.better = better;
    m.run_name = name + quantity;
    out.push_back(std::move(m));
  };
  // Another bias of those that are biased by design is neither better nor worse.
  add("mean square bias [radiance²]", entry.mean_square_bias, entry.mean_square_bias_standard_error,
      entry.should_be_unbiased() ? Better::Nearer : Better::Unknown);
  out.back().target = 0.0;
  add("noise [radiance]", entry.noise, entry.noise_standard_error, Better::Less);
}

/// `t_degrees`: z is close to Student's t with so many degrees of freedom (compare/images/paired_bias.h).
void add_row(const SamplingEntry& entry, double t_degrees, Measurements& out) {
  Measurement m =
      measurement_of(entry, "RMS bias of the picture ÷ mean radiance, with the sign of its square", std::nullopt);
  const Number &square = entry.mean_square_bias, &radiance = entry.mean_radiance;
  if (square && radiance && *radiance > 0.0) m.value = std::copysign(std::sqrt(std::abs(*square)), *square) / *radiance;
  if (entry.z && t_degrees > 0.0) m.z = normal_equivalent_of_t(*entry.z, t_degrees);
  m.listed_as = m.z ? CaseStatus::Measured : CaseStatus::NoResult;
  out.push_back(std::move(m));
}

}  // namespace

void measure_sampling_study(const Json& report, Measurements& out) {
  const SamplingFindings found = sampling_findings(report).value_or(SamplingFindings{});
  const Number replicates = found.conditions.replicates;
  // One degree of freedom less than there are pairs of replicates.
  const double t_degrees = replicates ? 0.5 * *replicates * (*replicates - 1.0) - 1.0 : 0.0;
  const std::size_t first = out.size();
  for (const SamplingEntry& entry : found.entries) add_row(entry, t_degrees, out);
  mark_by_z(std::span(out).subspan(first));
  for (const SamplingEntry& entry : found.entries) {
    add_judged(entry, out);
    add_compared(entry, degrees_of(replicates), out);
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
