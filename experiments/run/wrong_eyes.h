#pragma once
#include "lensmodel/eye.h"

namespace sturm {

// Eyes that a predictor may take a measured eye for by mistake. Eyes without a wavefront stay as they are.

/// x → −x: a right eye taken for a left one.
Eye mirrored_eye(const Eye& eye);

/// p → −p: its point spreads are turned round by 180°.
Eye point_reflected_eye(const Eye& eye);

/// The numbers of its coefficients, which are those of OSA, are read as those of Noll.
Eye eye_read_as_noll(const Eye& eye);

/// Its coefficients are taken to be those of the pupil in use, not of the one that was measured.
Eye eye_of_wrong_pupil(const Eye& eye);

/// All of the pupil counts alike. Any eye.
Eye eye_without_stiles_crawford(const Eye& eye);

}  // namespace sturm
