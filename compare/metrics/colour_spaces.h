#pragma once
#include <array>

namespace sturm {

/// Three coordinates of a colour, in the space that the function says.
using Colour = std::array<float, 3>;

/// Linear Rec. 709 light ↔ CIE XYZ (D65, white at Y = 1): the exact matrix of the primaries and the white point of IEC
/// 61966-2-1.
Colour xyz_of_light(const Colour& light);
Colour light_of_xyz(const Colour& xyz);

/// CIE L*a*b* of an XYZ colour under D65, L* in [0, 100].
Colour lab_of_xyz(const Colour& xyz);

/// The opponent space YCxCz of spatial filtering [Flohr1993]: L*a*b* without the cube root, hence linear in light.
Colour opponent_of_xyz(const Colour& xyz);
Colour xyz_of_opponent(const Colour& opponent);

}  // namespace sturm
