#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/ellipses/ellipse_comparison.h"
#include "compare/ellipses/image_ellipse.h"
#include "conoid/tracing/footprint.h"
#include "experiments/run/replicates.h"
#include "experiments/run/sections.h"
#include "experiments/standard/predicted_spot.h"
#include "io/images/exr.h"
#include "io/json/values.h"
#include "lensmodel/units.h"
#include "stages/ray_bundle.h"

namespace sturm {

namespace {

constexpr int replicate_count = 8;  // independent pictures, so that every pixel has a measured variance
constexpr double emitter_radius_px = 1.5;
constexpr double margin_px = 4.0;               // dark border around the spot
constexpr RayBundleSpec bundle_of_reference{};  // 16 × 65536 rays: far more than the picture's

struct Spot {
  RayModel model;
  BundleEllipse bundle;
};

/// A black world with one small sphere that glows with radiance 1, `distance_m` ahead. Its outline is a circle of slope
/// `radius`.
SceneDescription emitter_ahead(double distance_m, double radius) {
  SceneDescription scene;
  Material glow;
  glow.name = "emitter";
  glow.emission = {1.0f, 1.0f, 1.0f};
  scene.materials.push_back(glow);
  // Tangents from the eye touch a sphere of radius R at slope R/√(d² − R²).
  const double sphere_radius = distance_m * radius / std::sqrt(1.0 + radius * radius);
  scene.spheres.push_back(
      {Eigen::Vector3f(0.0f, 0.0f, static_cast<float>(-distance_m)), static_cast<float>(sphere_radius), 0});
  return scene;
}

CameraPose square_view(int resolution, double pixel) {
  CameraPose pose;
  pose.width = pose.height = resolution;
  pose.vertical_field = 2.0 * std::atan(0.5 * pixel * resolution);
  return pose;
}

Json arcminutes(const Eigen::Vector2d& v) {
  return json_of(Eigen::Vector2d(arcminutes_per_radian * v));
}

/// A measured ellipse that is nearly a circle has an angle made of noise: none is given.
Json ellipse_json(const Ellipse& e) {
  const bool circle = e.semi_minor > circle_axis_ratio * e.semi_major;
  return {{"semi_axes_arcmin", semi_axes_json(e, arcminutes_per_radian)},
          {"orientation_deg", circle ? Json(nullptr) : number_or_null(e.orientation_deg)}};
}

Json measured_json(const ImageEllipse& e, double hits) {
  Json entry = ellipse_json(e.ellipse);
  entry["hits"] = hits;
  entry["centroid_arcmin"] = arcminutes(e.centroid);
  entry["centroid_standard_error_arcmin"] =
      e.centroid_standard_error ? arcminutes(*e.centroid_standard_error) : Json(nullptr);
  entry["standard_error_arcmin"] =
      e.semi_axis_standard_errors ? arcminutes(*e.semi_axis_standard_errors) : Json(nullptr);
  return entry;
}

/// The bundles of all models; their spots set the field of view.
std::vector<Spot> bundles_of(const PsfExperiment& spec, const Footprint& footprint, std::uint64_t seed) {
  std::vector<Spot> spots;
  for (const RayModel model : spec.ray_models) {
    const MeasuredBundle bundle = measure_bundle(eye_rays_for(model, spec.eye, footprint.accommodation_D).value(),
                                                 1.0 / footprint.distance_m, bundle_of_reference, seed);
    if (bundle.angular) spots.push_back({model, *bundle.angular});
  }
  return spots;
}

/// What mutations make of the finished entries of one PSF, as patches (RFC 7396) of the `power_matrix` entry.
void add_mutated(Json& entries, const PsfExperiment& spec, const Footprint& footprint,
                 std::span<const Mutation> mutations) {
  const auto entry_of = [&](RayModel model) {
    return std::find_if(entries.begin(), entries.end(),
                        [&](const Json& entry) { return entry.at("ray_model") == name_of(model); });
  };
  const auto matrix = entry_of(RayModel::power_matrix), sin2 = entry_of(RayModel::sin2_radial);
  if (matrix == entries.end()) return;
  for (const Mutation& mutation : mutations) {
    Json patch;
    if (const auto wrong = mutated_footprint(mutation, spec.eye, footprint))
      patch["predicted"] = ellipse_json(Ellipse::image_of_disc(wrong->angular, spec.eye.pupil_radius_m));
    else if (std::holds_alternative<mutation::DroppedTangentialTerm>(mutation.kind) && sin2 != entries.end())
      patch["measured"] = sin2->at("measured");
    else if (std::holds_alternative<mutation::HalfPixelShift>(mutation.kind)) {
      const Json& pixel = matrix->at("pixel_arcmin");
      patch["measured"]["centroid_arcmin"] = matrix->at("measured").at("centroid_arcmin");
      patch["measured"]["centroid_arcmin"][0] =
          patch["measured"]["centroid_arcmin"][0].get<double>() + 0.5 * pixel.get<double>();
    }
    if (!patch.is_null()) (*matrix)["mutated"][mutation.id] = std::move(patch);
  }
}

}  // namespace

Json psf_entries(const PsfExperiment& spec, std::uint64_t seed, std::span<const Mutation> mutations,
                 const std::filesystem::path& folder, const ProgressFunction& progress) {
  const Footprint footprint = naked_eye_footprint(spec.eye, spec.distance_m);
  // One target, one accommodation: the picture is taken with the one that the eye chose for it.
  Eye eye = spec.eye;
  eye.accommodation = FixedAccommodation{footprint.accommodation_D, spec.eye.stated_focus_distance_m().value_or(0.0)};
  const Ellipse predicted = Ellipse::image_of_disc(footprint.angular, spec.eye.pupil_radius_m);
  const std::vector<Spot> spots = bundles_of(spec, footprint, seed);
  double reach = predicted.semi_major;
  for (const Spot& spot : spots) reach = std::max(reach, spot.bundle.ellipse.semi_major);
  constexpr double least_reach = 1e-4;  // a spot in perfect focus still gets a field of view [rad]
  const double pixel = 2.0 * std::max(reach, least_reach) / (spec.resolution - 2.0 * (margin_px + emitter_radius_px));
  const double emitter = emitter_radius_px * pixel;

  const Scene scene(emitter_ahead(spec.distance_m, emitter));
  const CameraPose pose = square_view(spec.resolution, pixel);
  SpotImaging imaging;
  imaging.pixel_slope = pixel;
  imaging.axis_px = {0.5 * spec.resolution, 0.5 * spec.resolution};
  imaging.emitter_covariance = 0.25 * emitter * emitter * Eigen::Matrix2d::Identity();

  const std::string predicted_file = "psf/" + spec.id + "_predicted.exr";
  const Image prediction =
      predicted_spot(spec.eye.pupil_radius_m / pixel * footprint.angular, emitter_radius_px, spec.resolution);
  write_exr(folder / predicted_file, LayeredImage{{{"", prediction}}, {}});

  Json entries = Json::array();
  for (std::size_t k = 0; k < spots.size(); ++k) {
    RenderSettings settings;
    settings.samples_per_pixel = std::max(1, static_cast<int>(spec.samples_per_pixel) / replicate_count);
    settings.max_bounces = 0;
    const Replicates pictures = render_replicates(
        scene, pose, eye, spots[k].model, settings, seed, replicate_count,
        [&](double fraction) { progress((static_cast<double>(k) + fraction) / static_cast<double>(spots.size())); });
    const Image variance = pictures.variance_of_mean();
    const Image mean = pictures.mean();
    const ImageEllipse measured = measure_image_ellipse(mean, &variance, imaging);
    double light = 0.0;
    for (std::size_t i = 0; i < mean.pixels.size(); i += 3) light += mean.pixels[i];
    const double hits = std::round(light * settings.samples_per_pixel * replicate_count);
    const std::string file = "psf/" + spec.id + "_" + name_of(spots[k].model) + ".exr";
    write_exr(folder / file, LayeredImage{{{"", mean}}, {}});
    entries.push_back({{"id", spec.id},
                       {"prescription", spec.prescription},
                       {"distance_m", spec.distance_m},
                       {"pupil_mm", 2e3 * spec.eye.pupil_radius_m},
                       {"ray_model", name_of(spots[k].model)},
                       {"file", file},
                       {"files", {{"predicted", predicted_file}}},
                       {"pixel_arcmin", pixel * arcminutes_per_radian},
                       {"resolution", spec.resolution},
                       {"predicted", ellipse_json(predicted)},
                       {"measured", measured_json(measured, hits)},
                       {"bundle", ellipse_json(spots[k].bundle.ellipse)}});
  }
  add_mutated(entries, spec, footprint, mutations);
  return entries;
}

}  // namespace sturm
