#include "io/specs/pupil_sampling_spec.h"

#include <nlohmann/json.hpp>

namespace sturm {

PupilSamplingSpec read_pupil_sampling(const Json& value, const Source& where) {
  PupilSamplingSpec spec;
  const std::string name = value.value("sampling", "uniform_disk");
  if (name == "uniform_polar") spec.kind = PupilSampling::UniformPolar;
  if (name == "uniform_polar_weighted") spec.kind = PupilSampling::UniformPolarWeighted;
  if (name == "rings") spec.kind = PupilSampling::Rings;
  if (const auto rings = value.find("rings"); rings != value.end()) {
    if (spec.kind != PupilSampling::Rings) (where / "rings").fail(*rings, "no \"rings\" for sampling \"" + name + "\"");
    spec.rings = rings->value("count", spec.rings);
    spec.angle_factor = rings->value("angle_factor", spec.angle_factor);
  }
  return spec;
}

}  // namespace sturm
