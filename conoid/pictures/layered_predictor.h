#pragma once
#include <vector>

#include "conoid/pictures/image_predictor.h"
#include "conoid/pictures/multipass.h"
#include "conoid/pictures/sight_field.h"
#include "io/images/fragment_image.h"

namespace sturm {

/// The eye's picture as a sum of ellipses of every surface that its pupil sees: the fragments of a sharp view, and
/// `unseen` pieces that only the pupil's other points see (behind edges, beyond the border; conoid/pictures/multipass.h
/// finds them).
///
/// A point at vergence V on the chief ray of place q' is seen at q' + M(q', V) p (SightNeighbourhood::picture_map):
/// each piece is spread over its own ellipse with exact area weights, whatever the gaze and the spectacles, so
/// curvature of field and oblique astigmatism are in it. Layers are composited as in conoid/pictures/image_predictor.h.
/// Of a pixel on an edge each surface counts as if nothing stood before it: what is nearer covers it anyway.
///
/// What it leaves out: an ellipse is evaluated where the surface is, not where it is seen, so an eye that accommodates
/// at every place sees a surface as sharp as when it looks at it, also beside an edge; edges over each other count as
/// complementary; a pixel is spread from its centre, but at the rims of lamps: from the middle of the part of it that a
/// surface fills, in little blur from 8 × 8 places there.
///
/// Deterministic: the same bits for any number of threads. Throws std::invalid_argument where view and field do not fit
/// and for ellipses of more than 16384 px.
Prediction predict_by_layers(const FragmentImage& view, int oversampling, const SightField& field,
                             const std::vector<UnseenPiece>& unseen, const PredictorSettings& settings = {});

}  // namespace sturm
