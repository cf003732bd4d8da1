#pragma once
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// A squared difference from the reference value r over r² + 0.01. The offset keeps black pixels from dividing by zero;
/// it is the value that the literature uses.
double relative_square(double squared_difference, double reference);

/// Errors of single pixels, each the mean over its channels, in the order of the pixels. Test x, reference r. All throw
/// InputError as `require_comparable`.

/// (x − r)².
std::vector<double> squared_errors(const Image& test, const Image& reference);

/// `relative_square` of each.
std::vector<double> relative_squared_errors(const Image& test, const Image& reference);

/// |x − r|/(|x| + |r| + 0.01): the symmetric relative error that SMAPE is the mean of, below 1, without the factor 2
/// that some give it.
std::vector<double> symmetric_relative_errors(const Image& test, const Image& reference);

/// Mean of `symmetric_relative_errors`.
double smape(const Image& test, const Image& reference);

/// Errors as a one-channel image.
Image error_map(const std::vector<double>& errors, int width, int height);

}  // namespace sturm
