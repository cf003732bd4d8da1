#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>

namespace sturm::stress {

/// Extended precision: 64 bits of mantissa on x86, 2^-64 of rounding against double's 2^-53.
using Extended = long double;

/// A number with its derivatives by the four coordinates of a ray that starts near the chief ray: offset x, y and slope
/// x, y at the pupil. Forward-mode differentiation: exact first derivatives, nothing is expanded by hand.
struct Dual {
  Extended value = 0.0L;
  std::array<Extended, 4> d{};

  Dual() = default;
  Dual(Extended v) : value(v) {}  // NOLINT: constants mix with duals
  Dual(Extended v, int coordinate) : value(v) { d[static_cast<std::size_t>(coordinate)] = 1.0L; }
};

inline Dual chained(Extended value, Extended slope, const Dual& a) {
  Dual r(value);
  for (std::size_t i = 0; i < 4; ++i) r.d[i] = slope * a.d[i];
  return r;
}
inline Dual operator+(const Dual& a, const Dual& b) {
  Dual r(a.value + b.value);
  for (std::size_t i = 0; i < 4; ++i) r.d[i] = a.d[i] + b.d[i];
  return r;
}
inline Dual operator-(const Dual& a, const Dual& b) {
  Dual r(a.value - b.value);
  for (std::size_t i = 0; i < 4; ++i) r.d[i] = a.d[i] - b.d[i];
  return r;
}
inline Dual operator*(const Dual& a, const Dual& b) {
  Dual r(a.value * b.value);
  for (std::size_t i = 0; i < 4; ++i) r.d[i] = a.d[i] * b.value + a.value * b.d[i];
  return r;
}
inline Dual operator*(Extended a, const Dual& b) {
  return chained(a * b.value, a, b);
}
inline Dual inverse(const Dual& a) {
  const Extended v = 1.0L / a.value;
  return chained(v, -v * v, a);
}
inline Dual operator/(const Dual& a, const Dual& b) {
  return a * inverse(b);
}
inline Dual sqrt(const Dual& a) {
  const Extended v = std::sqrt(a.value);
  return chained(v, 0.5L / v, a);
}
inline Extended inverse(Extended a) {
  return 1.0L / a;
}
inline Extended value_of(Extended a) {
  return a;
}
inline Extended value_of(const Dual& a) {
  return a.value;
}

/// Three components; Eigen would want traits for each scalar.
template <class T>
struct Vec3 {
  T x, y, z;
};
template <class T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec3<T> operator*(const T& s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec3<T> normalized(const Vec3<T>& a) {
  using std::sqrt;
  return inverse(sqrt(dot(a, a))) * a;
}
inline Vec3<Extended> extended(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
inline Vec3<Extended> value_of(const Vec3<Dual>& v) {
  return {v.x.value, v.y.value, v.z.value};
}
inline Vec3<Extended> derivative(const Vec3<Dual>& v, std::size_t i) {
  return {v.x.d[i], v.y.d[i], v.z.d[i]};
}
inline Eigen::Vector3d rounded(const Vec3<Extended>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// What the smallest rotation that takes −z to `to` makes of x and y: e − (e·to)(to − z)/(1 − to·z).
struct Frame {
  Vec3<Extended> e1, e2;
};
inline Frame frame_across(const Vec3<Extended>& to) {
  const Extended f = 1.0L / (1.0L - to.z);
  return {{1.0L - f * to.x * to.x, -f * to.x * to.y, to.x}, {-f * to.x * to.y, 1.0L - f * to.y * to.y, to.y}};
}

}  // namespace sturm::stress
