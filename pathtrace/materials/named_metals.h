#pragma once
#include <Eigen/Core>
#include <array>
#include <string_view>

namespace sturm {

/// Complex index η + iκ of a metal in air for red, green and blue.
struct NamedMetal {
  std::string_view name;
  std::array<float, 3> eta, kappa;
};

/// Measured spectra (Palik, Handbook of Optical Constants of Solids, and the SOPRA collection) weighted to linear Rec.
/// 709 primaries: the table of the Tungsten renderer (B. Bitterli, ComplexIorData.hpp), there under the symbols Au, Cu,
/// Ag and Al.
inline constexpr std::array<NamedMetal, 4> named_metals{{
    {"gold", {0.1431189557f, 0.3749570432f, 1.4424785571f}, {3.9831604247f, 2.3857207478f, 1.6032152899f}},
    {"copper", {0.2004376970f, 0.9240334304f, 1.1022119527f}, {3.9129485033f, 2.4528477015f, 2.1421879552f}},
    {"silver", {0.1552646489f, 0.1167232965f, 0.1383806959f}, {4.8283433224f, 3.1222459278f, 2.1469504455f}},
    {"aluminium", {1.6574599595f, 0.8803689579f, 0.5212287346f}, {9.2238691996f, 6.2695232477f, 4.8370012281f}},
}};

}  // namespace sturm
