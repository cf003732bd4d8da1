#include <algorithm>
#include <cmath>

#include "compare/psf/distances.h"
#include "compare/psf/encircled_energy.h"
#include "conoid/tracing/footprint.h"
#include "experiments/sin2_study/pupil_trace.h"
#include "experiments/sin2_study/sin2_study.h"
#include "io/images/exr.h"
#include "io/json/values.h"
#include "lensmodel/units.h"
#include "stages/ray_bundle.h"

namespace sturm {

namespace {

constexpr int picture_px = 160;
constexpr double margin = 1.1;              // half the picture's side over the longest semi-axis
constexpr double cells_per_semi_axis = 12;  // of the total variation

struct GalleryModel {
  const char* name;
  RayModel model;
  bool tangential;          ///< with the tangential term added
  std::uint32_t replicate;  ///< its own points of the pupil, so that no two patterns share their noise
};
constexpr GalleryModel gallery_models[] = {{"wavefront", RayModel::power_matrix, false, 0},
                                           {"sin2_radial", RayModel::sin2_radial, false, 1},
                                           {"repaired", RayModel::sin2_radial, true, 2},
                                           {"metalstigmatism", RayModel::metalstigmatism, false, 3}};
constexpr std::uint32_t noise_replicate = 4;

/// One eye, one target: what its rays are traced through.
struct GalleryScene {
  const Sin2GalleryView& view;
  double target_vergence_D, accommodation_D;
  std::uint64_t rays, seed;

  /// The angles of a model's rays [rad]; none where it is undefined.
  std::optional<std::vector<Eigen::Vector2d>> angles(const GalleryModel& m, std::uint32_t replicate) const {
    const auto eye_rays = eye_rays_for(m.model, view.eye, accommodation_D);
    if (!eye_rays) return std::nullopt;
    std::vector<Eigen::Vector2d> pupil(rays), result;
    fill_unit_disk(Sequence::Sobol, seed, replicate, 0, pupil);
    const TangentialTerm tangential(view.eye.correction);
    for (const Eigen::Vector2d& u : pupil) {
      const Eigen::Vector2d p = view.eye.pupil_radius_m * u;
      PupilRay<double> ray = eye_rays->through(p.x(), p.y());
      if (!goes_on(ray.status)) continue;
      if (m.tangential) tangential.add_to(ray);
      result.push_back(naked_angle(ray, target_vergence_D));
    }
    if (result.empty()) return std::nullopt;
    return result;
  }
};

/// Cells are centred on the origin, so that rays on an axis do not fall to either side by rounding.
PointSpread spread_about_cells(const std::vector<Eigen::Vector2d>& angles, double cell_arcmin) {
  PointSpread spread = spread_of_rays(angles, false);
  for (Eigen::Vector2d& p : spread.points) p += Eigen::Vector2d::Constant(0.5 * cell_arcmin);
  return spread;
}

/// Share of the light per arcmin²; rays beyond the picture are not shown.
Image density(const std::vector<Eigen::Vector2d>& angles, double half_side_arcmin) {
  Image image(picture_px, picture_px, 3);
  const double pixel = 2.0 * half_side_arcmin / picture_px,
               each = 1.0 / (static_cast<double>(angles.size()) * pixel * pixel);
  for (const Eigen::Vector2d& angle : angles) {
    const Eigen::Vector2d at = arcminutes_per_radian * angle / pixel;
    const double x = std::floor(at.x() + 0.5 * picture_px), y = std::floor(0.5 * picture_px - at.y());
    if (x < 0.0 || y < 0.0 || x >= picture_px || y >= picture_px) continue;
    float* channels = image.at(static_cast<int>(x), static_cast<int>(y));
    for (int k = 0; k < 3; ++k) channels[k] += static_cast<float>(each);
  }
  return image;
}

Sin2Spread spread_entry(const GalleryModel& m, const std::vector<Eigen::Vector2d>& angles, const PointSpread& truth,
                        double noise, double cell) {
  const PointSpread spread = spread_about_cells(angles, cell);
  const double distance = total_variation(spread, truth, cell).value;
  // Points of a scrambled Sobol' sequence scatter less than the independent ones of these errors, by how much is not
  // known from one set. Radii are about the centroid, whose own scatter moves them by no more than itself; where a
  // pattern has a pole it is most of it.
  PointSpread independent = spread;
  independent.independent_rays = static_cast<double>(angles.size());
  const WithError radius_50 = encircled_energy_radius(independent, 0.5),
                  radius_80 = encircled_energy_radius(independent, 0.8);
  const double centroid_error = std::sqrt(spread.covariance().trace() / independent.independent_rays);
  return {.model = m.name,
          .total_variation = distance,
          .total_variation_over_noise = distance / noise,
          .radius_50_arcmin = radius_50.value,
          .radius_80_arcmin = radius_80.value,
          .radius_50_error_of_independent_rays_arcmin = *radius_50.standard_error + centroid_error,
          .radius_80_error_of_independent_rays_arcmin = *radius_80.standard_error + centroid_error};
}

}  // namespace

Sin2GalleryEntry sin2_gallery_entry(const Sin2StudySpec& spec, const Sin2GalleryView& view, std::uint64_t seed,
                                    const std::filesystem::path& folder) {
  const double vergence = vergence_of(view.distance_m), accommodation = view.eye.accommodation_for(vergence);
  const Ellipse truth = Ellipse::image_of_disc(naked_eye_footprint(view.eye, view.distance_m, accommodation).angular,
                                               view.eye.pupil_radius_m);
  const double longest = arcminutes_per_radian * truth.semi_major;
  Sin2GalleryEntry entry{.id = view.id,
                         .title = view.title,
                         .sphere_D = view.eye.prescription.sphere_D,
                         .cylinder_D = view.eye.prescription.cylinder_D,
                         .axis_deg = view.eye.prescription.axis_deg,
                         .distance_m = StoredDistance{view.distance_m},
                         .pupil_mm = 2e3 * view.eye.pupil_radius_m,
                         .accommodation_D = accommodation,
                         .half_side_arcmin = margin * longest};
  if (!(longest > 0.0)) return entry;
  const double cell = longest / cells_per_semi_axis;
  const GalleryScene scene{view, vergence, accommodation, spec.gallery_rays, seed};
  const auto wavefront = *scene.angles(gallery_models[0], gallery_models[0].replicate);
  const PointSpread reference = spread_about_cells(wavefront, cell);
  const double noise =
      total_variation(spread_about_cells(*scene.angles(gallery_models[0], noise_replicate), cell), reference, cell)
          .value;
  entry.cell_arcmin = cell;
  entry.noise_total_variation = noise;
  for (const GalleryModel& m : gallery_models) {
    const auto angles = scene.angles(m, m.replicate);
    if (!angles) continue;
    Sin2Spread of_model = spread_entry(m, *angles, reference, noise, cell);
    const std::string file = "psf/gallery_" + view.id + "_" + m.name + ".exr";
    write_exr(folder / file, LayeredImage{{{"", density(*angles, margin * longest)}}, {}});
    of_model.file = file;
    entry.models.push_back(std::move(of_model));
  }
  return entry;
}

}  // namespace sturm
