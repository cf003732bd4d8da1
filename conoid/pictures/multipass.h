#pragma once
#include "conoid/pictures/ray_shading.h"
#include "conoid/pictures/sight_field.h"
#include "io/images/fragment_image.h"
#include "io/images/image.h"

namespace sturm {

struct PassSettings {
  int passes = 64;       ///< displacement vectors in the pupil, ≥ 1
  int lamp_factor = 16;  ///< ≥ 1: so many times more of them in pixels where a ray that meets a lamp would be a 32nd of
                         ///< the pixel's light, and as many times more again where it would still be a quarter
  int rays_per_place = 16;  ///< at most so many of the rays that found an unseen place go to the shader
};

struct PassCounters {
  long long rays = 0;                ///< through pupil points, all pixels and passes
  long long unseen_rays = 0;         ///< those whose surface the sharp view does not show
  long long unseen_places = 0;       ///< shaded for them
  long long lamp_pixels = 0;         ///< that got more passes because of a lamp
  long long bright_lamp_pixels = 0;  ///< those of them that got still more
  long long lost_pixels = 0;         ///< whose chief ray spectacles stop: black
};

struct PassPrediction {
  Image radiance;
  Image unseen;  ///< 1 channel: share of a pixel's rays that the sharp view did not know
  PassCounters counters;
};

/// The eye's picture blended from passes through points of the pupil ([Kakimoto2010] §5: N vectors, each displaces the
/// scene by the blur field and a pinhole draws it).
///
/// Kakimoto moves the vertices of a finely tessellated scene by X(d) p and rasterises; here each pixel sends the
/// first-order conoid ray of each pupil point (conoid/pictures/sight_field.h) into the scene as it is. A vertex that is
/// displaced by X(d) p is seen by the pinhole in just the pixel whose ray through p meets it, so this is the limit of
/// infinitely fine tessellation, with the field taken at the pixel instead of at the vertex: occlusion is exact for
/// each pass, and no geometry is rebuilt. The colour of what a ray meets is looked up in one sharp view: the fragment
/// of that surface at the place whose chief ray goes there. What the sharp view does not show (behind edges, beyond its
/// border) is collected from all passes, shaded once for each pixel-sized place, and used by all rays that meet it.
///
/// N points cut the rim of a lamp of radiance L into steps of L/N, and a lamp that is smaller than the blur over √N
/// into as many single lamps. Where a lamp's rim is within reach (conoid/pictures/lamp_reach.h) and L/N is more than
/// 1/32 of what the pixel has, the pixel is traced anew with `lamp_factor` times as many points, and where L/N still is
/// more than a quarter, with as many times more again.
///
/// What it is not: lens sampling. No light path starts in the pupil except those of unseen places; shading is that of
/// the chief ray, so highlights and reflections stay where the pupil's centre sees them; rays are first order in the
/// pupil; N points stand for the disc.
///
/// `view` covers the picture of `field`, `oversampling` pixels of it for each along each side. `first_hits` is asked by
/// up to 8 rays at a time. A pupil with Stiles–Crawford apodization weights its passes. The result is the same, bit for
/// bit, for any number of threads. Throws std::invalid_argument where view and field do not fit.
PassPrediction predict_by_passes(const FragmentImage& view, int oversampling, const SightField& field,
                                 const FirstHits& first_hits, const PlaceShader& shade,
                                 const PassSettings& settings = {});

/// What the passes would miss in a sharp view, shaded: for predictors that spread surfaces instead of tracing pupil
/// points.
struct UnseenPiece {
  Eigen::Vector2d place;  ///< its chief place in the picture [px]; may lie outside
  double vergence_D;      ///< 1/t along its chief ray; 0 for the surroundings
  Eigen::Vector3f radiance;
  float share = 1.0f;  ///< of its sharp pixel that a lamp fills, from 256 chief rays that pass what stands before it;
                       ///< of all else unknown: 1
};
std::vector<UnseenPiece> unseen_pieces(const FragmentImage& view, int oversampling, const SightField& field,
                                       const FirstHits& first_hits, const PlaceShader& shade,
                                       const PassSettings& settings, PassCounters& counters);

}  // namespace sturm
