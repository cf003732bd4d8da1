#include "compare/studies/samplings/sampling_statistics.h"

#include <cmath>

#include "io/json/stored.h"

namespace sturm {

void add_sampling_study(const Json& report, Statistics& out) {
  Extreme unbiased, polar(Extreme::Of::Smallest);
  for (const Json& entry : array_at(report, "sampling_study/entries")) {
    const std::string sampling = text_at(entry, "sampling");
    const std::string name = text_at(entry, "configuration") + "|" + sampling + "|" + text_at(entry, "sampler");
    const Number z = number_at(entry, "z");
    const bool through_a_point = text_at(entry, "ray_model") == "pinhole";  // where on the pupil makes no difference
    if (through_a_point || sampling == "uniform_disk" || sampling == "uniform_polar_weighted")
      unbiased.add(z ? Number(std::abs(*z)) : z, name);
    else if (sampling == "uniform_polar")
      polar.add(z, name);
  }
  out["sampling_unbiased_max_z"] = unbiased.result();
  out["sampling_raw_polar_min_z"] = polar.result();
}

}  // namespace sturm
