#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/pupil_sampling_spec.h"
#include "lensmodel/words.h"

namespace sturm {

enum class Sequence { Sobol, Halton, Independent };

inline constexpr Words<Sequence, 3> sequence_words{
    {{Sequence::Sobol, "sobol"}, {Sequence::Halton, "halton"}, {Sequence::Independent, "independent"}}};

/// The word for it in documents.
inline std::string name_of(Sequence sequence) {
  return std::string(sequence_words.word_of(sequence));
}

/// Gauss–Legendre in r², equally spaced angles.
struct QuadratureSpec {
  int radial = 0;
  int azimuthal = 0;
};

/// The pupil points that rays go through: `replicates` independent sets of `count` points, or a quadrature, or given
/// points.
struct RayBundleSpec {
  std::uint64_t count = 65536;  ///< rays per replicate
  int replicates = 16;          ///< independent scramblings
  Sequence sequence = Sequence::Sobol;
  PupilSamplingSpec sampling;
  std::optional<QuadratureSpec> quadrature;     ///< if given, count, replicates and sequence mean nothing
  std::vector<Eigen::Vector2d> pupil_points_m;  ///< the same, if not empty; wearer frame [m]
};

/// Reads a "rays" object (null: all defaults). Points must lie in the pupil of radius `pupil_radius_m`. Throws
/// InputError.
RayBundleSpec read_ray_bundle(const Json& value, const Source& where, double pupil_radius_m);

}  // namespace sturm
