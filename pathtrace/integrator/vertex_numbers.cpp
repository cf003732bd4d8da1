#include "pathtrace/integrator/vertex_numbers.h"

namespace sturm {

VertexNumbers::Vertex VertexNumbers::single_vertex(std::uint32_t sample, int bounce) const {
  const std::uint32_t first = first_dimension(bounce);
  const auto light = sequence_.pair(sample, first + dimension::light),
             scatter = sequence_.pair(sample, first + dimension::scatter);
  return {unit_float(light.x), unit_float(light.y), cosine_local(unit_float(scatter.x), unit_float(scatter.y))};
}

void VertexNumbers::fill(int bounce) {
  if (count_ <= size / 2)
    fill_lanes<size / 2>(bounce);
  else
    fill_lanes<size>(bounce);
}

template <int lanes>
void VertexNumbers::fill_lanes(int bounce) {
  const std::uint32_t first = first_dimension(bounce), first_sample = first_sample_;
  const owen_sobol::Keys light = sequence_.keys(first + dimension::light),
                         scatter = sequence_.keys(first + dimension::scatter),
                         survive = sequence_.keys(first + dimension::survive);
  Depth& d = depths_[bounce];
  for (int i = 0; i < lanes; ++i) {
    const auto u = owen_sobol::pair(first_sample + static_cast<std::uint32_t>(i), light);
    d.light_u[i] = unit_float(u.x);
    d.light_v[i] = unit_float(u.y);
  }
  for (int i = 0; i < lanes; ++i) {
    const auto u = owen_sobol::pair(first_sample + static_cast<std::uint32_t>(i), scatter);
    d.x[i] = unit_float(u.x);
    d.y[i] = unit_float(u.y);
  }
  for (int i = 0; i < lanes; ++i) {
    const LocalDirection w = cosine_local(d.x[i], d.y[i]);
    d.x[i] = w.x;
    d.y[i] = w.y;
    d.z[i] = w.z;
  }
  for (int i = 0; i < lanes; ++i)
    d.survive[i] = unit_float(owen_sobol::single(first_sample + static_cast<std::uint32_t>(i), survive));
}

}  // namespace sturm
