#pragma once
#include <cstddef>
#include <vector>

namespace sturm {

/// A polynomial Σ c_{ik} xⁱ yᵏ of total degree ≤ degree.
class PlanePolynomial {
 public:
  explicit PlanePolynomial(int degree = 0)
      : degree_(degree), coefficients_(static_cast<std::size_t>((degree + 1) * (degree + 2) / 2), 0.0) {}

  int degree() const { return degree_; }
  double& at(int i, int k) { return coefficients_[index(i, k)]; }
  double at(int i, int k) const { return coefficients_[index(i, k)]; }

  /// Value by Horner's rule in y of Horner's rules in x.
  template <class T>
  T operator()(T x, T y) const {
    T sum = T(0);
    std::size_t next = coefficients_.size();
    for (int k = degree_; k >= 0; --k) {  // the row of yᵏ has the powers 0 … degree − k of x
      T row = T(0);
      for (int i = degree_ - k; i >= 0; --i) row = row * x + T(coefficients_[--next]);
      sum = sum * y + row;
    }
    return sum;
  }

  /// Its coefficients of x⁰, x¹, … where y is given: for many values with one y.
  std::vector<double> in_x(double y) const {
    std::vector<double> row(static_cast<std::size_t>(degree_ + 1), 0.0);
    for (int k = degree_; k >= 0; --k)
      for (int i = 0; i <= degree_; ++i)
        row[static_cast<std::size_t>(i)] = row[static_cast<std::size_t>(i)] * y + (i + k <= degree_ ? at(i, k) : 0.0);
    return row;
  }

  PlanePolynomial derivative_x() const;
  PlanePolynomial derivative_y() const;

 private:
  /// Rows k = 0, 1, …, each from x⁰ on, one after the other.
  std::size_t index(int i, int k) const { return static_cast<std::size_t>(k * (degree_ + 1) - k * (k - 1) / 2 + i); }

  int degree_;
  std::vector<double> coefficients_;
};

/// OSA/ANSI single index j = (n(n + 2) + m)/2 of a Zernike polynomial of order n and azimuthal frequency m (ANSI
/// Z80.28).
struct ZernikeIndex {
  int n, m;

  static ZernikeIndex of(int j);
  int single() const { return (n * (n + 2) + m) / 2; }
};

/// Z_j over the unit disc as a polynomial, normalised to unit variance; θ counter-clockwise from +x, cos for m ≥ 0, sin
/// for m < 0.
PlanePolynomial zernike_polynomial(int j);

}  // namespace sturm
