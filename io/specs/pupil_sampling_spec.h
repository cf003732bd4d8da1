#pragma once
#include <string>

#include "io/json/json.h"
#include "lensmodel/words.h"

namespace sturm {

/// How points are spread over the pupil (docs/theory.md#53-pupil-sampling). All but the first are other pupils than a
/// uniform one, except for the weighted.
enum class PupilSampling {
  UniformDisk,   ///< uniform over the area: the reference
  UniformPolar,  ///< radius and angle uniform, as METALSTIGMATISM prints it: denser at the centre, E[r²] = a²/3
  UniformPolarWeighted,  ///< the same points with the weight 2r/a: the uniform pupil again
  Rings  ///< Wang & Xiao: ring k of n at r = k/n·a carries angle_factor·k points; E[r²] = (n + 1)/(2n)·a²
};

inline constexpr Words<PupilSampling, 4> pupil_sampling_words{
    {{PupilSampling::UniformDisk, "uniform_disk"},
     {PupilSampling::UniformPolar, "uniform_polar"},
     {PupilSampling::UniformPolarWeighted, "uniform_polar_weighted"},
     {PupilSampling::Rings, "rings"}}};

/// The word for it in documents.
inline std::string name_of(PupilSampling sampling) {
  return std::string(pupil_sampling_words.word_of(sampling));
}

struct PupilSamplingSpec {
  PupilSampling kind = PupilSampling::UniformDisk;
  int rings = 8;         ///< n
  int angle_factor = 6;  ///< points on the first ring
};

/// Reads "sampling" and "rings" of a "rays" or "method" object. Throws InputError for "rings" beside another sampling.
PupilSamplingSpec read_pupil_sampling(const Json& value, const Source& where);

}  // namespace sturm
