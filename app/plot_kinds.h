#pragma once
#include "lensmodel/words.h"

namespace sturm {

/// What `sturm plot` draws.
enum class PlotKind { Blur, Spots, Wavefront, Mtf, Ellipses, Power, Defocus, Corridor };

inline constexpr Words<PlotKind, 8> plot_kind_words{{{PlotKind::Blur, "blur"},
                                                     {PlotKind::Spots, "spots"},
                                                     {PlotKind::Wavefront, "wavefront"},
                                                     {PlotKind::Mtf, "mtf"},
                                                     {PlotKind::Ellipses, "ellipses"},
                                                     {PlotKind::Power, "power"},
                                                     {PlotKind::Defocus, "defocus"},
                                                     {PlotKind::Corridor, "corridor"}}};

}  // namespace sturm
