#pragma once
#include <Eigen/Core>
#include <vector>

namespace sturm {

/// One pass of a picture that is blended from many: a point of the unit disc, and a place within the pixel, [0, 1)².
struct PupilPass {
  Eigen::Vector2f pupil, film;
};

/// `count` ≥ 1 passes whose pupil points lie on a sunflower [Vogel1979], r² = (k + ½)/count, each a golden angle on
/// from the last: equal weights, mean r² exactly ½. Their places in the pixel follow the additive recurrence of the
/// plastic number [Roberts2018]. (Kakimoto's displacement vectors are such points.)
///
/// `turn` in [0, 1) turns the sunflower by that part of a circle and shifts the places: neighbouring pixels get
/// different ones, so that few passes leave fine grain instead of as many sharp copies of the scene (interleaved
/// sampling, [KellerHeidrich2001]).
std::vector<PupilPass> pupil_passes(int count, double turn = 0.0);

/// The passes of the 4 × 4 pixels of a pattern that fills the picture; pixel (x, y) takes set (y mod 4)·4 + x mod 4.
std::vector<std::vector<PupilPass>> interleaved_passes(int count);

}  // namespace sturm
