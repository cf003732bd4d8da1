#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/gates/extreme_statistic.h"
#include "io/json/record.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// Number of eyes and views, and how rays were sampled.
struct Sin2Conditions {
  Count eyes{}, grid_eyes{}, real_eyes{};
  std::vector<StoredDistance> distances_m{};
  std::vector<double> pupil_diameters_mm{};
  std::vector<std::string> accommodations{};
  Count radial{}, azimuthal{}, rings{}, angle_factor{};
  std::optional<StoredDistance> reference_distance_m{};
  Number reference_pupil_mm{};
  Count gallery_rays{};

  bool operator==(const Sin2Conditions&) const = default;
};

/// Cases and rays of one ray model.
struct Sin2ModelRow {
  std::optional<RayModel> ray_model{};
  std::string title{};
  Count cases{}, undefined{}, pole{};
  Number rays{}, rays_dropped{}, rays_negative_focus{}, largest_error_D{};
  std::optional<std::string> largest_error_case{};

  bool operator==(const Sin2ModelRow&) const = default;
};

/// The largest or smallest value of a quantity over the cases that were asked.
struct Sin2Check {
  Number value{};
  Count cases{};
  std::optional<std::string> worst_case{};  ///< the one that decided

  bool operator==(const Sin2Check&) const = default;
};
using Sin2Checks = std::map<std::string, Sin2Check>;

struct Distribution {
  Number median{}, p90{}, max{};

  bool operator==(const Distribution&) const = default;
};

/// What a model does to the real eyes in one view; without state and distance: in each eye's worst view.
struct Sin2PopulationRow {
  std::optional<RayModel> ray_model{};
  std::optional<std::string> accommodation{};
  std::optional<StoredDistance> distance_m{};
  Count eyes{}, pole{}, noticeable{};
  Distribution error_D{}, error_arcmin{}, error_percent{};

  bool operator==(const Sin2PopulationRow&) const = default;
};

/// Errors over the grid, a row per cylinder; none where the model has none.
struct Sin2Map {
  std::optional<RayModel> ray_model{};
  std::vector<std::vector<Number>> error_D{};

  bool operator==(const Sin2Map&) const = default;
};

/// Of eyes without a cylinder: sphere [D], semi-axis of the blur by wavefront theory and by the model [arcmin].
struct Sin2Curve {
  std::optional<RayModel> ray_model{};
  std::vector<std::array<Number, 3>> points{};

  bool operator==(const Sin2Curve&) const = default;
};

/// Errors of the real eyes, by rising size.
struct Sin2Cumulative {
  std::optional<RayModel> ray_model{};
  std::vector<Number> error_D{};

  bool operator==(const Sin2Cumulative&) const = default;
};

/// The numbers behind the figures.
struct Sin2ReferenceView {
  std::vector<double> spheres_D{}, cylinders_D{};
  std::vector<Sin2Map> maps{};
  std::vector<Sin2Curve> curves{};
  std::vector<Sin2Cumulative> cumulative{};

  bool operator==(const Sin2ReferenceView&) const = default;
};

/// The image of a point by one model of the gallery.
struct Sin2Spread {
  std::string model;  ///< "wavefront", "sin2_radial", "repaired" (sin² with the tangential term), "metalstigmatism"
  Number total_variation{}, total_variation_over_noise{};  ///< from wavefront theory's
  Number radius_50_arcmin{}, radius_80_arcmin{};           ///< about the centroid, with so much of the light within
  Number radius_50_error_of_independent_rays_arcmin{}, radius_80_error_of_independent_rays_arcmin{};
  std::string file{};  ///< EXR with the density, in the run folder

  bool operator==(const Sin2Spread&) const = default;
};

/// One view of the gallery. In perfect focus it has no pictures, nor a size of the cells that they are compared in.
struct Sin2GalleryEntry {
  std::string id{}, title{};
  Number sphere_D{}, cylinder_D{}, axis_deg{};
  std::optional<StoredDistance> distance_m{};
  Number pupil_mm{}, accommodation_D{}, half_side_arcmin{}, cell_arcmin{}, noise_total_variation{};
  std::vector<Sin2Spread> models{};

  bool operator==(const Sin2GalleryEntry&) const = default;
};

/// Section "sin2_study" of a report.
struct Sin2StudyFindings {
  Sin2Conditions conditions{};
  std::vector<Sin2ModelRow> models{};
  Sin2Checks checks{};
  std::vector<Sin2PopulationRow> population{};
  Sin2ReferenceView reference_view{};
  std::vector<Sin2GalleryEntry> gallery{};

  bool operator==(const Sin2StudyFindings&) const = default;

  /// A check that may be missing.
  const Sin2Check* check(const std::string& name) const;
  /// The row over each eye's worst view; null if there is none.
  const Sin2PopulationRow* worst_views(RayModel model) const;
};

Json to_json(const Sin2StudyFindings& findings);

/// Of a report; none without the section.
std::optional<Sin2StudyFindings> sin2_study_findings(const Json& report);

/// Its parts.
Json to_json(const Sin2Checks& checks);
Json to_json(const std::vector<Sin2ModelRow>& models);
Json to_json(const std::vector<Sin2PopulationRow>& population);
Json to_json(const Sin2ReferenceView& view);

/// A step of the run, both ways.
Json to_json(const Sin2GalleryEntry& entry);
Sin2GalleryEntry sin2_gallery_entry_from(const Json& json);

}  // namespace sturm
