#pragma once
#include <Eigen/Core>
#include <concepts>
#include <cstdint>

#include "pathtrace/cameras/ray_model.h"
#include "pathtrace/sampling/sequence.h"

namespace sturm {

/// A ray as it starts into the scene, from the pupil or from the front surface of spectacles.
struct CameraRay {
  Eigen::Vector3f origin;     ///< [m], world
  Eigen::Vector3f direction;  ///< world, not normalised: one unit of t is one metre of the camera's distance
  LaunchStatus status;        ///< unless it `goes_on`, origin and direction mean nothing
};

/// Rays of a block of consecutive samples of one pixel, as structure of arrays; each is a CameraRay.
struct CameraRayBlock {
  static constexpr int size = 16;
  alignas(64) float origin[3][size];
  alignas(64) float direction[3][size];
  LaunchStatus status[size];
  float weight[size];  ///< of the sample, mean 1; only from cameras that are `weighted`
};

/// What the path tracer and its guides ask of a camera. It is immutable: whatever it answers depends on the arguments
/// alone.
///
/// Frames. Film places are in pixels from the upper left corner of the picture, x to the wearer's right, y down; pixel
/// (x, y) goes from there to (x + 1, y + 1). Pupil points are in metres from the pupil's centre in the wearer frame, x
/// to the wearer's right, y up, on the axes of the pupil where the eye turns. Rays are in the world, in metres. A place
/// farther right on the film is seen farther to the wearer's right, a lower one farther down.
///
/// - `C::weighted`: whether samples have weights other than 1. Only then `generate` writes them.
/// - `width()`, `height()`: of the picture [px].
/// - `pixel(x, y)`: what all samples of a pixel share.
/// - `film_place(pixel, numbers)`: where two random words fall in the pixel.
/// - `place_of(pixel, sample, sequence)`: the film place and the pupil point of one sample; the same whenever it is
///   asked, so that any sample can be replayed. Its `film` is the film place.
/// - `pupil_point(place)`: the pupil point [m].
/// - `single(pixel, place)`: the ray of one such place.
/// - `generate(x, y, first_sample, sequence, block)`: fills the block with the samples from `first_sample` on. Ray i is
///   `single` of the place of sample first_sample + i, bit for bit: no ray depends on its block.
template <class C>
concept Camera = requires(const C& camera, int x, int y, const typename C::Pixel& pixel,
                          const typename C::SamplePlace& place, owen_sobol::Pair numbers, std::uint32_t sample,
                          const PixelSequence& sequence, CameraRayBlock& block) {
  requires std::same_as<decltype(C::weighted), const bool>;
  { camera.width() } -> std::same_as<int>;
  { camera.height() } -> std::same_as<int>;
  { camera.pixel(x, y) } -> std::same_as<typename C::Pixel>;
  { camera.film_place(pixel, numbers) } -> std::same_as<typename C::FilmPlace>;
  { camera.place_of(pixel, sample, sequence) } -> std::same_as<typename C::SamplePlace>;
  { place.film } -> std::convertible_to<typename C::FilmPlace>;
  { camera.pupil_point(place) } -> std::same_as<Eigen::Vector2f>;
  { camera.single(pixel, place) } -> std::same_as<CameraRay>;
  { camera.generate(x, y, sample, sequence, block) } -> std::same_as<void>;
};

}  // namespace sturm
