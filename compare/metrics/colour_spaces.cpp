#include "compare/metrics/colour_spaces.h"

#include <cmath>

namespace sturm {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

// Exact rationals of the Rec. 709 primaries (.64 .33), (.30 .60), (.15 .06) and the white point (.3127 .3290).
constexpr Matrix to_xyz = {{{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                            {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                            {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};

constexpr Matrix inverse(const Matrix& m) {
  const auto minor = [&](int r, int c) {
    const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3,
              c2 = (c + 2) % 3;  // cyclic: the sign comes out by itself
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) result[r][c] = minor(c, r) / determinant;
  return result;
}

constexpr Matrix from_xyz = inverse(to_xyz);

constexpr std::array<double, 3> white_point() {
  std::array<double, 3> w{};
  for (int i = 0; i < 3; ++i) w[i] = to_xyz[i][0] + to_xyz[i][1] + to_xyz[i][2];
  return w;
}

constexpr std::array<double, 3> white = white_point();

Colour product(const Matrix& m, const Colour& v) {
  Colour result;
  for (int i = 0; i < 3; ++i)
    result[i] =
        static_cast<float>(m[i][0]) * v[0] + static_cast<float>(m[i][1]) * v[1] + static_cast<float>(m[i][2]) * v[2];
  return result;
}

Colour relative_to_white(const Colour& xyz) {
  return {xyz[0] / static_cast<float>(white[0]), xyz[1] / static_cast<float>(white[1]),
          xyz[2] / static_cast<float>(white[2])};
}

/// The three differences that both L*a*b* and YCxCz are made of.
Colour opponents(const Colour& f) {
  return {116.0f * f[1] - 16.0f, 500.0f * (f[0] - f[1]), 200.0f * (f[1] - f[2])};
}

/// Cube root with the straight line below (6/29)³.
float lightness_response(float t) {
  constexpr float delta = 6.0f / 29.0f;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
}

}  // namespace

Colour xyz_of_light(const Colour& light) {
  return product(to_xyz, light);
}

Colour light_of_xyz(const Colour& xyz) {
  return product(from_xyz, xyz);
}

Colour lab_of_xyz(const Colour& xyz) {
  const Colour t = relative_to_white(xyz);
  return opponents({lightness_response(t[0]), lightness_response(t[1]), lightness_response(t[2])});
}

Colour opponent_of_xyz(const Colour& xyz) {
  return opponents(relative_to_white(xyz));
}

Colour xyz_of_opponent(const Colour& opponent) {
  const float y = (opponent[0] + 16.0f) / 116.0f;
  return {(y + opponent[1] / 500.0f) * static_cast<float>(white[0]), y * static_cast<float>(white[1]),
          (y - opponent[2] / 200.0f) * static_cast<float>(white[2])};
}

}  // namespace sturm
