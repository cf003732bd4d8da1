#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compare/findings/measurement.h"
#include "io/json/json.h"
#include "lensmodel/ellipse.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// What the second moments of a path-traced spot say. Angles in arcmin.
struct MeasuredSpot {
  std::optional<Ellipse> ellipse;                        ///< without an orientation where it is nearly a circle
  std::optional<Eigen::Vector2d> standard_error_arcmin;  ///< of the semi-axes (major, minor)
  std::optional<Eigen::Vector2d> centroid_arcmin;        ///< from the chief ray's place
  std::optional<Eigen::Vector2d> centroid_standard_error_arcmin;  ///< (x, y)
  Number hits;                                                    ///< rays that met the emitter
};

/// The path-traced image of one point-like emitter by one ray model. Ellipses in arcmin.
struct PsfFinding {
  std::string id, prescription;  ///< of the emitter, of the prescription
  Number distance_m;             ///< may be ∞
  Number pupil_mm;
  std::optional<RayModel> ray_model;
  std::string file, predicted_file;         ///< EXR, relative to the run folder
  Number pixel_arcmin;                      ///< width of a pixel
  std::optional<std::uint64_t> resolution;  ///< [px], square
  std::optional<Ellipse> predicted;         ///< by the conoid
  std::optional<MeasuredSpot> measured;
  std::optional<Ellipse> bundle;              ///< of the same eye's rays without a picture
  std::map<std::string, PsfFinding> mutated;  ///< what it would be with a predictor made wrong, by the mutation's id
};

/// The section "psfs", with "mutated" in its entries if there is any.
Json to_json(const std::vector<PsfFinding>& psfs);

/// Of a report ("sturm.report/1").
std::vector<PsfFinding> read_psfs(const Json& report);

}  // namespace sturm
