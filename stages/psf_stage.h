#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/specs/psf_spec.h"
#include "wavefront/psf/ray_fan.h"

namespace sturm {

/// What is known of one point spread. Angles in the frame that the spec asks for.
struct MeasuredSpread {
  PsfModel model;                        ///< how it was computed
  std::size_t light, target;             ///< numbers in the spec
  Eigen::Vector2d centroid;              ///< [rad]; that of waves is the one of rays
  std::vector<std::vector<double>> mtf;  ///< by direction, then frequency
  std::vector<std::optional<double>> radii_about_chief_ray, radii_about_centroid;  ///< [rad], of each share of energy
  std::optional<Eigen::Matrix2d> covariance;                        ///< of rays [rad²]; that of diffraction has no end
  std::optional<double> strehl_origin, strehl_peak, visual_strehl;  ///< of waves
  std::optional<Eigen::Vector2d> peak;                              ///< of waves [rad]
  std::optional<WaveSampling> sampling;                             ///< of waves
  PsfCells picture;  ///< energy in the spec's pixels, the chief ray in the middle of the middle one
};

/// Total variation between rays and waves in one light for one target, for each size of cells.
struct PsfDistance {
  std::size_t light, target;            ///< numbers in the spec
  std::vector<double> total_variation;  ///< 0 … 1, for each of `cells_arcmin`
};

/// The answer to a document of point spreads.
struct PointSpreads {
  std::vector<MeasuredSpread>
      spreads;  ///< all models of the first light's first target first, then its other targets …
  std::vector<PsfDistance> distances;  ///< empty unless both models were asked for
};

/// Throws InputError where a wave would alias.
PointSpreads point_spreads(const PsfSpec& spec, const std::string& file);

/// The sturm.psf_result/1 document.
Json psf_result(const PsfSpec& spec, const PointSpreads& spreads);

}  // namespace sturm
