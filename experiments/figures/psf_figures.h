#pragma once
#include <string>
#include <vector>

#include "io/specs/psf_spec.h"
#include "reports/plots/mtf_plot.h"
#include "reports/plots/spot_plot.h"

namespace sturm {

/// A spot diagram for each target of the spec in its first light, of so many rays; the ellipse is that of all rays.
std::vector<SpotDiagram> spot_diagrams(const PsfSpec& spec, std::size_t rays);

/// Modulation transfer of each model, target and direction in the spec's first light. Throws InputError about `file`
/// where a wave would alias.
std::vector<MtfCurve> mtf_curves(const PsfSpec& spec, const std::string& file);

}  // namespace sturm
