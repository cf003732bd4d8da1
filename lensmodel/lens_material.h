#pragma once
#include <optional>
#include <span>
#include <string_view>

namespace sturm {

/// What lenses are made of.
struct LensMaterial {
  std::string_view name;
  double refractive_index;
  double abbe_number;  ///< dispersion: (n − 1) over the difference of the indices for blue and red
};

/// Nominal values as the trade lists them. Data sheets state them for the d or the e line, which differ by about 0.002
/// in the index, and makers' values scatter by 0.005 in the index and 1 in the Abbe number.
std::span<const LensMaterial> lens_materials();

/// None for an unknown name.
std::optional<LensMaterial> lens_material(std::string_view name);

}  // namespace sturm
