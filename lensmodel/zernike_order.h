#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "lensmodel/words.h"
#include "lensmodel/zernike.h"

namespace sturm {

/// The ways in which programs and instruments number Zernike polynomials (docs/theory.md#52-measured-wavefronts).
enum class ZernikeOrder {
  Osa,    ///< j = (n(n + 2) + m)/2 from 0 (ANSI Z80.28)
  Noll,   ///< from 1; even numbers are cosines, odd ones sines (Noll 1976)
  Fringe  ///< from 1, by n + |m|; the University of Arizona's set of 37
};

inline constexpr Words<ZernikeOrder, 3> zernike_order_words{
    {{ZernikeOrder::Osa, "osa"}, {ZernikeOrder::Noll, "noll"}, {ZernikeOrder::Fringe, "fringe"}}};  ///< in documents

/// The number that a list of coefficients starts with: 0 of OSA, 1 of the others.
int first_number(ZernikeOrder order);

/// The last number that is understood: up to radial order 20, of Fringe 37.
int last_number(ZernikeOrder order);

/// Order and azimuthal frequency of the polynomial with a number. Fringe 37 is Z₁₂⁰, with which the set of 37 ends.
/// Throws std::invalid_argument beyond [first_number, last_number].
ZernikeIndex zernike_index(ZernikeOrder order, int number);

/// Whether coefficients in this order usually belong to polynomials of unit variance; those of Fringe are 1 at the rim.
bool usually_normalised(ZernikeOrder order);

/// Standard deviation over the disc of a polynomial whose largest value at the rim is 1, 1/√((2 − δ_m0)(n + 1)): times
/// this, its coefficient becomes that of the normalised polynomial.
double unnormalised_deviation(const ZernikeIndex& index);

/// OSA coefficients of normalised polynomials, from j = 0 on, from coefficients that start with `first_number`.
std::vector<double> osa_coefficients(std::span<const double> given, ZernikeOrder order, bool normalised);

/// Whether the coefficient of a frequency m changes its sign under x → −x: between right and left eyes, and between the
/// examiner's and the wearer's frame.
inline bool changes_sign_mirrored(int m) {
  return m >= 0 ? m % 2 == 1 : m % 2 == 0;
}

/// The same wavefront mirrored, x → −x, as OSA coefficients.
std::vector<double> mirrored(std::span<const double> osa);

}  // namespace sturm
