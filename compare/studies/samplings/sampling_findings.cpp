#include "compare/studies/samplings/sampling_findings.h"

#include "compare/studies/stored_words.h"

namespace sturm {

template <>
inline constexpr auto record_members<SamplingFiles> =
    std::tuple{member("picture", &SamplingFiles::picture), member("picture_png", &SamplingFiles::picture_png)};

template <>
inline constexpr auto record_members<SamplingConditions> =
    std::tuple{member("scene", &SamplingConditions::scene), member("pupil_mm", &SamplingConditions::pupil_mm),
               member("samples_per_pixel", &SamplingConditions::samples_per_pixel),
               member("replicates", &SamplingConditions::replicates)};

template <>
inline constexpr auto record_members<SamplingEntry> =
    std::tuple{member("configuration", &SamplingEntry::configuration),
               member("note", &SamplingEntry::note),
               member("ray_model", &SamplingEntry::ray_model),
               member("sampling", &SamplingEntry::sampling),
               member("sampler", &SamplingEntry::sampler),
               member("aspect_ratio", &SamplingEntry::aspect_ratio),
               member("pupil_rms_ratio", &SamplingEntry::pupil_rms_ratio),
               member("mean_radiance", &SamplingEntry::mean_radiance),
               member("noise", &SamplingEntry::noise),
               member("noise_standard_error", &SamplingEntry::noise_standard_error),
               member("mean_square_bias", &SamplingEntry::mean_square_bias),
               member("mean_square_bias_standard_error", &SamplingEntry::mean_square_bias_standard_error),
               member("z", &SamplingEntry::z),
               member("seconds", &SamplingEntry::seconds),
               member("files", &SamplingEntry::files)};

template <>
inline constexpr auto record_members<SamplingFindings> =
    std::tuple{member("conditions", &SamplingFindings::conditions), member("entries", &SamplingFindings::entries)};

bool SamplingEntry::should_be_unbiased() const {
  return ray_model == RayModel::pinhole || sampling == PupilSampling::UniformDisk ||
         sampling == PupilSampling::UniformPolarWeighted;
}

Json to_json(const SamplingFindings& findings) {
  return json_from(findings);
}

std::optional<SamplingFindings> sampling_findings(const Json& report) {
  return record_from<std::optional<SamplingFindings>>(value_at(report, "sampling_study"));
}

Json to_json(const std::vector<SamplingEntry>& entries) {
  return json_from(entries);
}

std::vector<SamplingEntry> sampling_entries_from(const Json& list) {
  return record_from<std::vector<SamplingEntry>>(list);
}

}  // namespace sturm
