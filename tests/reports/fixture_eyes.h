#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "lensmodel/prescription.h"

namespace sturm::test {

/// Uniform and normal numbers that are the same with every standard library.
class Scatter {
 public:
  double uniform() { return (static_cast<double>(engine_()) + 0.5) / 4294967296.0; }
  double normal() { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * std::numbers::pi * uniform()); }

 private:
  std::mt19937 engine_{12345};
};

constexpr double accommodation_D = 1.0;  ///< focused at 1 m

/// Of such an eye: what light from the target lacks [D].
Eigen::Matrix2d needed_vergence(const Prescription& rx, double distance_m);

/// Slope of a ray beyond the direction to the target, per metre of pupil: radial models return V(φ)·I.
Eigen::Matrix2d slope_map(const std::string& model, const Eigen::Matrix2d& V, double phi);

struct PsfSetup {
  const char *id, *prescription;
  Prescription rx;
  double distance_m, pupil_mm;
};

inline const std::array<PsfSetup, 2> psf_setups{{{"oblique", "with-the-rule", {-3.0, -1.5, 30.0, 0.012}, 1.0, 4.0},
                                                 {"between-the-lines", "mixed", {1.0, -2.0, 150.0, 0.012}, 1.0, 4.0}}};
constexpr int psf_resolution = 96;

/// Half the picture is 1.6 × the larger semi-axis.
double psf_pixel_rad(const PsfSetup& setup);

}  // namespace sturm::test
