#pragma once
#include "pathtrace/film/film.h"
#include "pathtrace/film/render.h"

namespace sturm {

/// A result with black layers: those that every rendering has, and those that the settings ask for.
RenderResult empty_result(int width, int height, const RenderSettings& settings);

/// Puts one pixel's statistics into the layers radiance and variance.
void store_radiance(RenderResult& result, int x, int y, const PixelStatistics& radiance);

/// Puts them into the layers albedo, normal and depth, and into the guide layers where the result has them.
void store_first_hit(RenderResult& result, int x, int y, const FirstHitStatistics& first_hit,
                     const GuideStatistics& guide);

}  // namespace sturm
