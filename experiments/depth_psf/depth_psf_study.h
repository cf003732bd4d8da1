#pragma once
#include <vector>

#include "compare/studies/depth_psf/depth_psf_findings.h"
#include "io/specs/experiment/depth_psf_study_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// Point spreads of one pupil [m] of the map, by rays and by waves, at every vergence error, in both lights.
std::vector<SpreadCell> spread_cells(const SpreadMapSpec& map, double pupil_diameter_m);

/// What the eyes of a table have beyond second order.
EyesBeyond eyes_beyond(const MeasuredEyes& eyes, const ProgressFunction& progress);

/// The slanted surface at every spacing of its planes, by nearest and by linear weights.
std::vector<BandingRow> banding_rows(const BandingSpec& banding, const ProgressFunction& progress);

}  // namespace sturm
