#pragma once
#include <span>
#include <vector>

namespace sturm {

/// Values as IEEE 754 binary16, little endian, two bytes each, rounded to nearest: a relative error of at most 2⁻¹¹
/// from 6.1e-5 to 65504 and an absolute one of at most 3e-8 below. Larger numbers become infinite, a NaN stays one.
std::vector<unsigned char> half_float_bytes(std::span<const float> values);

}  // namespace sturm
