#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "pathtrace/materials/bsdf.h"
#include "pathtrace/sampling/disk.h"

namespace sturm {

/// Isotropic GGX distribution of microfacet normals [Walter2007, eqs. 33–34] with Smith masking [Heitz2014]. α =
/// roughness². Directions lie in the upper hemisphere.
struct Ggx {
  float alpha;

  /// D(h) [1/sr]; tan² from x and y, so that nothing cancels near the pole.
  float density(const Eigen::Vector3f& h) const {
    const float a2 = alpha * alpha, q = h.x() * h.x() + h.y() * h.y() + a2 * h.z() * h.z();
    return a2 / (local::pi * q * q);
  }

  /// Smith's Λ; masking is 1 / (1 + Λ).
  float lambda(const Eigen::Vector3f& w) const {
    const float tangent_squared = (w.x() * w.x() + w.y() * w.y()) / (w.z() * w.z());
    const float q = alpha * alpha * tangent_squared;
    return 0.5f * q / (std::sqrt(1.0f + q) + 1.0f);  // (√(1 + q) − 1)/2 without cancellation
  }
  float masking(const Eigen::Vector3f& w) const { return 1.0f / (1.0f + lambda(w)); }

  /// Masking and shadowing of two directions on the same side, correlated by height [Heitz2014, eq. 99].
  float masking_shadowing(const Eigen::Vector3f& out, const Eigen::Vector3f& in) const {
    return 1.0f / (1.0f + lambda(out) + lambda(in));
  }

  /// Density of visible_normal(): G₁(out) D(h) (out·h) / cos θ_out.
  float visible_density(const Eigen::Vector3f& out, const Eigen::Vector3f& h) const {
    return masking(out) * density(h) * std::max(0.0f, out.dot(h)) / out.z();
  }

  /// A normal in proportion to its visible area [Heitz2018].
  Eigen::Vector3f visible_normal(const Eigen::Vector3f& out, float u, float v) const {
    const Eigen::Vector3f stretched = Eigen::Vector3f(alpha * out.x(), alpha * out.y(), out.z()).normalized();
    const float length = std::hypot(stretched.x(), stretched.y());
    const Eigen::Vector3f first = length > 0.0f ? Eigen::Vector3f(-stretched.y() / length, stretched.x() / length, 0.0f)
                                                : Eigen::Vector3f(1.0f, 0.0f, 0.0f);
    const Eigen::Vector3f second = stretched.cross(first);
    const auto d = concentric_disk(u, v);
    const float s = 0.5f * (1.0f + stretched.z());
    const float y = (1.0f - s) * std::sqrt(std::max(0.0f, 1.0f - d.x * d.x)) + s * d.y;
    const float z = std::sqrt(std::max(0.0f, 1.0f - d.x * d.x - y * y));
    const Eigen::Vector3f h = d.x * first + y * second + z * stretched;
    return Eigen::Vector3f(alpha * h.x(), alpha * h.y(), std::max(1e-9f, h.z())).normalized();
  }
};

}  // namespace sturm
