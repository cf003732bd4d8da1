#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace sturm {

struct DielectricFresnel {
  float reflectance;  ///< of unpolarised light; 1 in total internal reflection
  float cosine_in;    ///< of the refracted ray's angle to the normal; 0 in total internal reflection
};

/// Fresnel's equations at an interface of two dielectrics: `cosine` ∈ [0, 1] on the side of the ray, `eta` = far index
/// / near index.
inline DielectricFresnel fresnel_dielectric(float cosine, float eta) {
  const float sine_squared = std::max(0.0f, 1.0f - cosine * cosine) / (eta * eta);
  if (sine_squared >= 1.0f) return {1.0f, 0.0f};
  const float far = std::sqrt(1.0f - sine_squared);
  const float parallel = (eta * cosine - far) / (eta * cosine + far);
  const float perpendicular = (cosine - eta * far) / (cosine + eta * far);
  return {0.5f * (parallel * parallel + perpendicular * perpendicular), far};
}

/// Fresnel's equations for unpolarised light on a conductor of complex index η + iκ (relative to the medium outside),
/// per channel. Born & Wolf, Principles of Optics, §14.2.
inline Eigen::Vector3f fresnel_conductor(float cosine, const Eigen::Vector3f& eta, const Eigen::Vector3f& kappa) {
  Eigen::Vector3f reflectance;
  const float c2 = cosine * cosine, s2 = std::max(0.0f, 1.0f - c2);
  for (int k = 0; k < 3; ++k) {
    const float n2 = eta[k] * eta[k], k2 = kappa[k] * kappa[k], t = n2 - k2 - s2;
    // a + ib = √((η + iκ)² − sin²)
    const float squares = std::sqrt(t * t + 4.0f * n2 * k2);
    const float a = std::sqrt(std::max(0.0f, 0.5f * (squares + t)));
    const float perpendicular = (squares + c2 - 2.0f * a * cosine) / (squares + c2 + 2.0f * a * cosine);
    const float x = c2 * squares + s2 * s2, y = 2.0f * a * cosine * s2;
    reflectance[k] = 0.5f * perpendicular * (1.0f + (x - y) / (x + y));
  }
  return reflectance;
}

/// Schlick 1994: F₀ + (1 − F₀)(1 − cos θ)⁵.
inline float fresnel_schlick(float cosine, float at_normal) {
  const float m = 1.0f - cosine;
  return at_normal + (1.0f - at_normal) * (m * m) * (m * m) * m;
}

}  // namespace sturm
