#pragma once
#include <optional>
#include <string>
#include <vector>

#include "compare/gates/extreme_statistic.h"
#include "io/json/record.h"
#include "io/specs/pupil_sampling_spec.h"
#include "io/specs/ray_bundle_spec.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// The mean picture of an entry: paths in the run folder.
struct SamplingFiles {
  std::string picture{}, picture_png{};

  bool operator==(const SamplingFiles&) const = default;
};

/// Pictures by one spread of rays over the pupil against those by the uniform disc.
struct SamplingEntry {
  std::string configuration{}, note{};
  std::optional<RayModel> ray_model{};
  std::optional<PupilSampling> sampling{};
  std::optional<Sequence> sampler{};
  Number aspect_ratio{};                   ///< of the picture
  Number pupil_rms_ratio{};                ///< RMS radius of the points over a uniform disc's, in closed form
  Number mean_radiance{};                  ///< of the reference
  Number noise{}, noise_standard_error{};  ///< RMS deviation of one picture [radiance]; by the jackknife
  Number mean_square_bias{};               ///< unbiased estimate [radiance²], so it may be negative
  Number mean_square_bias_standard_error{};
  Number z{};        ///< the bias over the error that it has where there is none
  Number seconds{};  ///< of all pictures
  SamplingFiles files{};

  bool operator==(const SamplingEntry&) const = default;

  /// Through a point it makes no difference where on the pupil; the others are biased by design.
  bool should_be_unbiased() const;
};

/// What was rendered, and how often.
struct SamplingConditions {
  std::string scene{};  ///< as the experiment states it
  Number pupil_mm{};
  Count samples_per_pixel{}, replicates{};

  bool operator==(const SamplingConditions&) const = default;
};

/// Section "sampling_study" of a report.
struct SamplingFindings {
  SamplingConditions conditions{};
  std::vector<SamplingEntry> entries{};

  bool operator==(const SamplingFindings&) const = default;
};

Json to_json(const SamplingFindings& findings);

/// Of a report; none without the section.
std::optional<SamplingFindings> sampling_findings(const Json& report);

/// The entries of one step of the run, both ways.
Json to_json(const std::vector<SamplingEntry>& entries);
std::vector<SamplingEntry> sampling_entries_from(const Json& list);

}  // namespace sturm
