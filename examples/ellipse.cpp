// How large is the blur of an astigmatic eye at 0.8 m, and along which direction does it lie?
#include <sturm/conoid/tracing/footprint.h>
#include <sturm/lensmodel/ellipse.h>

#include <cstdio>

int main() {
  const sturm::Prescription rx{.sphere_D = -2.0, .cylinder_D = -1.5, .axis_deg = 30.0};
  const auto eye = sturm::Eye::with(rx, 4e-3);                                                // pupil of 4 mm
  const auto footprint = sturm::naked_eye_footprint(eye, 0.8);                                // at 0.8 m
  const auto ellipse = sturm::Ellipse::image_of_disc(footprint.angular, eye.pupil_radius_m);  // [rad]
  std::printf("%.12g %.12g %.9g\n", ellipse.semi_major, ellipse.semi_minor, ellipse.orientation_deg.value_or(0.0));
}
