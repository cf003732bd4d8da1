#pragma once
#include "io/images/image.h"
#include "lensmodel/eye.h"

namespace sturm {

/// What the predictor starts from: one sharp (pinhole) HDR rendering with depth, in `camera` gaze, with a guard band
/// around it.
struct SharpView {
  Image radiance;     ///< 3 channels, linear
  Image depth;        ///< 1 channel, planar distance along the line of sight [m], > 0; +∞ where nothing was hit. One
                      ///< surface's distance per pixel (the nearest that was seen), never a mean across an edge
  int margin_px = 0;  ///< width of the guard band on each side, in pixels of this image
  double pixel_slope =
      0;  ///< size of a pixel *of this image* in tangent image coordinates (slope units), same in x and y
  int oversampling = 1;  ///< pixels of this image per output pixel along each side
};

struct PredictionCounters {
  long long splatted_pixels = 0;  ///< source pixels that were spread
  long long sharp_pixels = 0;     ///< source pixels whose ellipse is so small that they were copied
  long long hidden_pixels =
      0;  ///< further source pixels that were guessed behind edges (io/images/disocclusion.h), spread or copied
  int layers = 0;  ///< depth layers that held any pixel
  double clipped_radius_px =
      0.0;  ///< largest semi-axis [output px] that reaches beyond the guard band (0: none): light from outside of
            ///< the band is missing in such ellipses; normalisation makes up for it from what is there
};

struct Prediction {
  Image radiance;  ///< without the guard band, output resolution
  Image coverage;  ///< 1 channel: how much of each pixel the layers covered before normalisation (1 = fully)
  PredictionCounters counters;
};

struct PredictorSettings {
  double layer_width_px =
      0.5;  ///< depth layers are so thin that the ellipse's semi-axes change by at most this many output pixels
  double sharp_below_px = 0.05;  ///< a larger semi-axis below this [output px] is copied, not spread
};

/// Predicts what the naked eye sees in `camera` gaze with the accommodation `accommodation_D` [D]: the pinhole image
/// spread pixel by pixel over its ellipse, in linear light. Deterministic: the same bits for any number of threads.
///
/// A point at planar depth d on the chief slope q is seen through pupil point p at slope q − V(d) p, V(d) = I/d + F −
/// A·I (docs/theory.md#4-the-footprint-of-the-pupil), so its light covers the ellipse q + V(d)·disc(a), with exact area
/// weights (conoid/pictures/ellipse_kernel.h). V is evaluated on a grid of 1/64 of a depth layer: semi-axes are within
/// layer_width_px/128 (0.004 px) of exact, and a plane of constant depth is exact.
///
/// Depth layers, uniform in dioptres, are composited from near to far with clipped additive coverage: a layer of
/// coverage α adds min(α, 1 − A) to the coverage A so far. Pieces of one surface that fall into two layers have
/// complementary coverage, so they must add. Far surfaces are continued a little way behind near edges
/// (io/images/disocclusion.h); the sum is divided by A at the end.
///
/// What this leaves out:
/// - one surface per pixel: mixed edge pixels belong to one depth as a whole, and what is hidden is a guess;
/// - edges of two objects over each other count as complementary (they add), where independent ones would multiply;
/// - inside a surface whose blur changes quickly A departs from 1; the excess is cut from the far side, a lack is
/// scaled up;
/// - a pixel is spread from its centre. As the sharp view is box filtered already and the weights integrate over the
/// output pixel,
///   a bright point's variance holds 1/12 px² of the sharp pixels too much: it shrinks with oversampling².
///
/// Throws std::invalid_argument for views whose sizes do not fit together, a pixel slope that is not positive, values
/// that are not finite (radiance) or not positive (depth), and depths so near that a semi-axis exceeds 16384 output
/// pixels.
Prediction predict_image(const SharpView& view, const Eye& eye, double accommodation_D,
                         const PredictorSettings& settings = {});

/// Guard band [px of `pixel_slope`] that the largest ellipse between the planar depths `nearest_m` > 0 and `farthest_m`
/// ≤ ∞ needs.
int required_margin_px(const Eye& eye, double accommodation_D, double pixel_slope, double nearest_m, double farthest_m);

}  // namespace sturm
