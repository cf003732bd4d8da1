#pragma once
#include "io/images/image.h"
#include "io/specs/denoise_spec.h"
#include "pathtrace/film/render.h"

namespace sturm {

/// What the filter reads: images of one size.
struct DenoiserInput {
  const Image& radiance;        ///< 3
  const Image& mean_variance;   ///< 3, variance of `radiance`
  const Image& guide_mean;      ///< the features of GuideStatistics
  const Image& guide_variance;  ///< variances of these means
};

/// Edge-avoiding à-trous wavelet filter [Dammertz2010]: 5 × 5 B3 spline taps (1, 4, 6, 4, 1)/16 with steps 1, 2, 4, …,
/// each tap weighted down where it looks different. As in [Schied2017] the variance is filtered along, and a difference
/// of radiance counts in units of its standard error instead of a width that is halved from level to level.
///
/// Behind a wide pupil the features are means over all that a pixel sees: they ramp where the picture is blurred, and
/// they are noisy there. So the part of a squared difference that the noise of both means explains is taken off first
/// (after [Rousselle2013]). Depth counts as vergence 1/distance, which is affine over a plane: what the local gradient
/// explains is taken off too.
///
/// For looking at: the result is biased, and no measurement reads it.
Image denoised(const DenoiserInput& input, const DenoiseSpec& spec);

/// The same of a rendering with guide_layers. Without mean_variance the sample variance over `samples_per_pixel` stands
/// for it, which is too much for low-discrepancy samples: the filter then smooths more.
Image denoised(const RenderResult& result, double samples_per_pixel, const DenoiseSpec& spec);

}  // namespace sturm
