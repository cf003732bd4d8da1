#include "pathtrace/scene/cut_outs.h"

#include <bit>

#include "pathtrace/scene/texture.h"

namespace sturm {

namespace {

constexpr float rounded_up = 1.0f + 1e-6f;  // a product that is the cutoff but for rounding reaches it

/// Uniform in [0, 1) and the same for the same words; the finalizer of MurmurHash3 after each.
class NumberOfWords {
 public:
  void add(std::uint32_t word) {
    state_ ^= word + 0x9e3779b9u + (state_ << 6) + (state_ >> 2);
    state_ ^= state_ >> 16;
    state_ *= 0x85ebca6bu;
    state_ ^= state_ >> 13;
    state_ *= 0xc2b2ae35u;
    state_ ^= state_ >> 16;
  }
  void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
  float number() const { return static_cast<float>(state_ >> 8) * 0x1p-24f; }

 private:
  std::uint32_t state_ = 0x5354524du;
};

float drawn_number(RTCRayN* rays, unsigned count, unsigned lane, std::uint32_t triangle) {
  NumberOfWords words;
  for (const float value :
       {RTCRayN_org_x(rays, count, lane), RTCRayN_org_y(rays, count, lane), RTCRayN_org_z(rays, count, lane),
        RTCRayN_dir_x(rays, count, lane), RTCRayN_dir_y(rays, count, lane), RTCRayN_dir_z(rays, count, lane)})
    words.add(value);
  words.add(triangle);
  return words.number();
}

}  // namespace

float CutOuts::Part::alpha(const Triangle& triangle, float u, float v) const {
  const auto& [opacity, nearest] = surfaces[triangle.surface];
  const float w = 1.0f - u - v;
  const auto& [a, b, c] = triangle.alpha;
  float alpha = opacity.factor * (a + u * (b - a) + v * (c - a));  // exact where all are the same
  if (opacity.texture) {
    const auto& uv = triangle.coordinates;
    alpha *= grey_texel(*opacity.texture, opacity.mapping, w * uv[0] + u * uv[1] + v * uv[2], nearest);
  }
  return alpha;
}

void CutOuts::pass_rays(const RTCFilterFunctionNArguments* arguments) {
  const Part& part = *static_cast<const Part*>(arguments->geometryUserPtr);
  const unsigned count = arguments->N;
  for (unsigned lane = 0; lane < count; ++lane) {
    if (arguments->valid[lane] == 0) continue;
    const unsigned number = RTCHitN_primID(arguments->hit, count, lane);
    const Triangle& triangle = part.triangles[number];
    const float alpha =
        part.alpha(triangle, RTCHitN_u(arguments->hit, count, lane), RTCHitN_v(arguments->hit, count, lane));
    const Opacity& opacity = part.surfaces[triangle.surface].opacity;
    const bool stops = opacity.mode == Opacity::Mode::mask ? rounded_up * alpha >= opacity.cutoff
                                                           : drawn_number(arguments->ray, count, lane, number) < alpha;
    if (!stops) arguments->valid[lane] = 0;
  }
}

void CutOuts::attach(RTCGeometry geometry, const std::vector<const Mesh*>& meshes,
                     const std::vector<Material>& materials) {
  Part& part = parts_.emplace_back();
  for (const Mesh* mesh : meshes) {
    const Material& material = materials[static_cast<std::size_t>(mesh->material)];
    const auto surface = static_cast<std::uint32_t>(part.surfaces.size());
    part.surfaces.push_back({material.opacity, material.nearest_filter});
    for (const auto& corners : mesh->triangles) {
      Triangle triangle{{}, {1.0f, 1.0f, 1.0f}, surface};
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.coordinates[k] =
            mesh->texture_coordinates.empty() ? Eigen::Vector2f(0.0f, 0.0f) : mesh->texture_coordinates[corners[k]];
        if (!mesh->vertex_colours.empty()) triangle.alpha[k] = mesh->vertex_colours[corners[k]].w();
      }
      part.triangles.push_back(triangle);
    }
  }
  rtcSetGeometryUserData(geometry, &part);
  rtcSetGeometryIntersectFilterFunction(geometry, pass_rays);
  rtcSetGeometryOccludedFilterFunction(geometry, pass_rays);
}

}  // namespace sturm
