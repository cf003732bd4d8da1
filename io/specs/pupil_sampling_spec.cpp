#include "io/specs/pupil_sampling_spec.h"

#include <nlohmann/json.hpp>

#include "io/specs/words.h"

namespace sturm {

PupilSamplingSpec read_pupil_sampling(const Json& value, const Source& where) {
  PupilSamplingSpec spec;
  spec.kind = word_or(value, "sampling", spec.kind, where, pupil_sampling_words);
  if (const auto rings = value.find("rings"); rings != value.end()) {
    if (spec.kind != PupilSampling::Rings)
      (where / "rings").fail(*rings, "no \"rings\" for sampling \"" + name_of(spec.kind) + "\"");
    spec.rings = rings->value("count", spec.rings);
    spec.angle_factor = rings->value("angle_factor", spec.angle_factor);
  }
  return spec;
}

}  // namespace sturm
