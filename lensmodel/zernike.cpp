#include "lensmodel/zernike.h"

#include <cmath>
#include <cstdlib>

namespace sturm {

namespace {

/// Binomial coefficient; exact in double for n ≤ 50.
double binomial(int n, int k) {
  double value = 1.0;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

}  // namespace

PlanePolynomial PlanePolynomial::derivative_x() const {
  PlanePolynomial d(degree_ > 0 ? degree_ - 1 : 0);
  for (int k = 0; k < degree_; ++k)
    for (int i = 1; i + k <= degree_; ++i) d.at(i - 1, k) = i * at(i, k);
  return d;
}

PlanePolynomial PlanePolynomial::derivative_y() const {
  PlanePolynomial d(degree_ > 0 ? degree_ - 1 : 0);
  for (int k = 1; k <= degree_; ++k)
    for (int i = 0; i + k <= degree_; ++i) d.at(i, k - 1) = k * at(i, k);
  return d;
}

ZernikeIndex ZernikeIndex::of(int j) {
  int n = 0;
  while ((n + 1) * (n + 2) / 2 <= j) ++n;
  return {n, 2 * j - n * (n + 2)};
}

PlanePolynomial zernike_polynomial(int j) {
  const auto [n, m] = ZernikeIndex::of(j);
  const int frequency = std::abs(m);
  const double norm = std::sqrt((m == 0 ? 1.0 : 2.0) * (n + 1));
  PlanePolynomial z(n);
  // R(r) r^-|m| is a polynomial in r² = x² + y²; r^|m| cos |m|θ and r^|m| sin |m|θ are real and imaginary part of (x +
  // iy)^|m|.
  for (int s = 0; 2 * s <= n - frequency; ++s) {
    const int half = (n - frequency) / 2 - s;  // power of r²
    const double radial = (s % 2 ? -1.0 : 1.0) * binomial(n - s, s) * binomial(n - 2 * s, half);
    for (int t = 0; t <= half; ++t)
      for (int q = m < 0 ? 1 : 0; q <= frequency; q += 2)  // i^q: 1, i, −1, −i
        z.at(2 * (half - t) + frequency - q, 2 * t + q) +=
            norm * radial * binomial(half, t) * binomial(frequency, q) * (q / 2 % 2 ? -1.0 : 1.0);
  }
  return z;
}

}  // namespace sturm
