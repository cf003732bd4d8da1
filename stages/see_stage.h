#pragma once
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "io/json/json.h"
#include "io/specs/seen_psf.h"
#include "lensmodel/eye.h"
#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// Parts of the pupil where nobody says how many.
inline constexpr int usual_parts = 8;

/// Who sees a picture, and how exactly.
struct SeeSettings {
  Eye eye;                                             ///< who sees; the pupil and the wave are taken from it
  double accommodation_D = 0.0;                        ///< ≥ 0 [D]; the mode of the eye does not count
  double pixel_slope = 0.0;                            ///< size of a pixel in tangent units, > 0
  SeenPsf psf = SeenPsf::Rays;                         ///< what kernels are made of
  bool chromatic = false;                              ///< R, G and B have kernels of their own
  int parts = 1;                                       ///< of the pupil; waves have one
  std::function<void(double fraction)> progress = {};  ///< of the blurring, called from worker threads; may be empty
};

/// What the eye sees.
struct SeenPicture {
  Image radiance;                                  ///< linear, 3 channels
  std::vector<double> planes_D;                    ///< vergences of the planes, ascending
  std::vector<int> radii_px;                       ///< of their kernels
  BlurCounters work;                               ///< what was done with the layers of each tile
  long long hidden_given = 0, hidden_guessed = 0;  ///< pixels of hidden surfaces
  int parts = 1;                                   ///< of the pupil that were composited
  std::map<std::string, double> seconds;           ///< wall-clock by part [s]
};

/// What an eye sees of a picture with a depth map (docs/theory.md#143-pictures-with-depth). `layers` are further
/// surfaces of the same size; what the picture hides of them counts. Where they say nothing about what lies behind an
/// edge it is guessed. `picture.hidden` and `picture.jump_D` are set here. Throws InputError where the blur is too
/// large for the picture.
SeenPicture see_picture(LayeredPicture& sharp, std::span<const PictureLayer> layers, const SeeSettings& settings);

/// The same of a picture whose `hidden` surfaces, coverage and `jump_D` are known.
SeenPicture see_surfaces(LayeredPicture& picture, const SeeSettings& settings);

/// Throws InputError as `see_picture` would where the blur at the nearest or farthest distance is too large, in a small
/// part of its time: for sequences, of which nothing is to be written then.
void require_blur(const LayeredPicture& sharp, std::span<const PictureLayer> layers, const SeeSettings& settings);

/// Counters for the manifest.
Json counters_of(const SeenPicture& seen);

/// What was done with every layer of every tile, for people.
std::string explanation_of(const SeenPicture& seen);

}  // namespace sturm
