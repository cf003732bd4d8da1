#include "lensmodel/lens_material.h"

#include <algorithm>
#include <array>

namespace sturm {

namespace {

constexpr std::array<LensMaterial, 7> materials{{
    {"CR-39", 1.498, 58.0},          // allyl diglycol carbonate (PPG)
    {"Trivex", 1.53, 45.0},          // polyurethane-urea (PPG)
    {"polycarbonate", 1.586, 30.0},  // bisphenol A polycarbonate
    {"MR-8", 1.60, 41.0},            // thiourethane (Mitsui Chemicals), index 1.60
    {"MR-7", 1.67, 32.0},            // thiourethane (Mitsui Chemicals), index 1.67
    {"MR-174", 1.74, 33.0},          // episulfide (Mitsui Chemicals), index 1.74
    {"crown glass", 1.523, 58.6},    // ophthalmic crown
}};

}  // namespace

std::span<const LensMaterial> lens_materials() {
  return materials;
}

std::optional<LensMaterial> lens_material(std::string_view name) {
  const auto found = std::find_if(materials.begin(), materials.end(),
                                  [&](const LensMaterial& material) { return material.name == name; });
  return found == materials.end() ? std::nullopt : std::optional(*found);
}

}  // namespace sturm
