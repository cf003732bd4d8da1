#include "pathtrace/materials/surface_model.h"

namespace sturm {

namespace {
/// The other side of a surface: half a turn about x, under which every model is symmetric.
Eigen::Vector3f turned(const Eigen::Vector3f& w) {
  return {w.x(), -w.y(), -w.z()};
}
}  // namespace

BsdfValue evaluate(const SurfaceModel& model, const Eigen::Vector3f& out, const Eigen::Vector3f& in,
                   const Eigen::Vector3f& albedo) {
  return std::visit(
      [&]<class Model>(const Model& m) {
        if constexpr (!is_transparent<Model>)
          if (out.z() < 0.0f) return m.evaluate(turned(out), turned(in), albedo);
        return m.evaluate(out, in, albedo);
      },
      model);
}

BsdfSample sample(const SurfaceModel& model, const Eigen::Vector3f& out, const BsdfNumbers& numbers,
                  const Eigen::Vector3f& albedo) {
  return std::visit(
      [&]<class Model>(const Model& m) {
        if constexpr (!is_transparent<Model>) {
          if (out.z() < 0.0f) {
            BsdfSample s = m.sample(turned(out), numbers, albedo);
            s.in = turned(s.in);
            return s;
          }
        }
        return m.sample(out, numbers, albedo);
      },
      model);
}

bool only_sharp(const SurfaceModel& model) {
  if (const auto* conductor = std::get_if<Conductor>(&model)) return conductor->roughness == 0.0f;
  if (const auto* tinted = std::get_if<TintedMetal>(&model)) return tinted->roughness == 0.0f;
  if (const auto* dielectric = std::get_if<Dielectric>(&model)) return dielectric->roughness == 0.0f;
  if (const auto* metal = std::get_if<SeedMetal>(&model)) return metal->alpha == 0.0f;
  return std::holds_alternative<SeedDielectric>(model);
}

}  // namespace sturm
