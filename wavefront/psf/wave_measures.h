#pragma once
#include <optional>
#include <vector>

#include "wavefront/psf/wave_psf.h"

namespace sturm {

/// Energy of a point spread within circles about a centre, as a share of all of it, over all angles.
class WaveEnergy {
 public:
  /// `centre` [rad].
  WaveEnergy(const WavePsf& psf, const Eigen::Vector2d& centre);

  /// ∫ over |X − centre| ≤ R: Σ OTF(ν) R J₁(2πR|ν|)/|ν|, so it does not know the grid's pixels.
  double within(double radius_rad) const;

  /// The radius [rad] that holds a share; none where the window is too small for it.
  std::optional<double> radius(double share) const;

 private:
  double bin_;                  ///< [cycles/rad]
  std::vector<double> masses_;  ///< of the OTF about |ν| = i·bin_
  double largest_;              ///< radius that the window holds
};

/// Visual Strehl ratio ∫ N(ν) Re OTF dν / ∫ N(ν) OTF_unaberrated dν with the contrast sensitivity
/// N = (0.0192 + 0.114 f) exp(−(0.114 f)^1.1), f in cycles per degree [MannosSakrison1974], as in [Iskander2006].
double visual_strehl(const WavePsf& psf, const PupilWave& pupil, const Light& light);

/// The energy in square cells of the point spread or, of rays, the share of them.
struct PsfCells {
  double cell_rad;         ///< side of a cell
  Eigen::MatrixXd energy;  ///< odd × odd; row iy, column ix from the most negative on; the middle one is about X = 0

  double outside() const { return 1.0 - energy.sum(); }  ///< the share that no cell has
};

/// Exact integrals over side × side cells of the spread, which is band-limited. It has one period, the window: what
/// lies beyond holds nothing.
PsfCells cells_of(const WavePsf& psf, double cell_rad, int side);

/// Total variation ½ Σ |p − q| over equal cells; the rest of the world is one more cell.
double total_variation(const PsfCells& p, const PsfCells& q);

}  // namespace sturm
