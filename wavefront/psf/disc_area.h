#pragma once

namespace sturm {

/// Area of the part of the rectangle [x0, x1] × [y0, y1], 0 ≤ x0 < x1 and 0 ≤ y0 < y1, that lies within the disc of a
/// radius about the origin: exact.
double area_within_disc(double x0, double x1, double y0, double y1, double radius);

}  // namespace sturm
