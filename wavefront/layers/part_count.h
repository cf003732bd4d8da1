#pragma once
#include <optional>
#include <span>

namespace sturm {

/// The error of a picture that was blurred with so many parts of the pupil, where all hidden layers are known: root
/// mean square, linear, within 16 px of an edge.
struct ErrorOfParts {
  int parts;
  double error;
};

/// Rounded up from the worst of the pictures of tests/wavefront/layers/test_planes.cpp, by rising number of parts.
std::span<const ErrorOfParts> errors_of_parts();

/// The fewest parts whose error is at most this one, if there are any.
std::optional<int> parts_for_error(double error);

}  // namespace sturm
