#include "experiments/standard/psf_findings.h"

#include <algorithm>
#include <cmath>

#include "compare/ellipses/ellipse_comparison.h"
#include "compare/ellipses/image_ellipse.h"
#include "conoid/tracing/footprint.h"
#include "experiments/run/replicates.h"
#include "experiments/standard/predicted_spot.h"
#include "io/images/exr.h"
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

/// In arcmin. A measured ellipse that is nearly a circle has an angle made of noise: none is given.
Ellipse arcminutes(const Ellipse& e) {
  const bool circle = e.semi_minor > circle_axis_ratio * e.semi_major;
  return {arcminutes_per_radian * e.semi_major, arcminutes_per_radian * e.semi_minor,
          circle ? std::nullopt : e.orientation_deg};
}

std::optional<Eigen::Vector2d> arcminutes(const std::optional<Eigen::Vector2d>& v) {
  return v ? std::optional<Eigen::Vector2d>(arcminutes_per_radian * *v) : std::nullopt;
}

MeasuredSpot spot_of(const ImageEllipse& e, double hits) {
  return {.ellipse = arcminutes(e.ellipse),
          .standard_error_arcmin = arcminutes(e.semi_axis_standard_errors),
          .centroid_arcmin = Eigen::Vector2d(arcminutes_per_radian * e.centroid),
          .centroid_standard_error_arcmin = arcminutes(e.centroid_standard_error),
          .hits = hits};
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

/// The picture of one emitter that all ray models share.
struct SpotView {
  double pixel;    ///< width of one, as a slope
  double emitter;  ///< radius of the emitter, as a slope
  CameraPose pose;

  SpotView(const PsfExperiment& spec, double reach)
      : pixel(2.0 * reach / (spec.resolution - 2.0 * (margin_px + emitter_radius_px))),
        emitter(emitter_radius_px * pixel),
        pose(square_view(spec.resolution, pixel)) {}

  SpotImaging imaging() const {
    SpotImaging imaging;
    imaging.pixel_slope = pixel;
    imaging.axis_px = {0.5 * pose.width, 0.5 * pose.height};
    imaging.emitter_covariance = 0.25 * emitter * emitter * Eigen::Matrix2d::Identity();
    return imaging;
  }
};

/// The largest semi-axis of prediction and rays, as a slope. A spot in perfect focus still gets a field of view.
double reach_of(const Ellipse& predicted, const std::vector<Spot>& spots) {
  constexpr double least_reach = 1e-4;
  double reach = std::max(predicted.semi_major, least_reach);
  for (const Spot& spot : spots) reach = std::max(reach, spot.bundle.ellipse.semi_major);
  return reach;
}

/// What was measured of the replicates of one spot, each pixel of which took `samples` in all.
MeasuredSpot measured_spot(const Replicates& pictures, const Image& mean, const SpotView& view, double samples) {
  const Image variance = pictures.variance_of_mean();
  double light = 0.0;
  for (std::size_t i = 0; i < mean.pixels.size(); i += 3) light += mean.pixels[i];
  return spot_of(measure_image_ellipse(mean, &variance, view.imaging()), std::round(light * samples));
}

/// What a mutation makes of the `power_matrix` finding `honest` of one PSF, whose finding with `sin2_radial` is `sin2`;
/// none where it is none of spots.
std::optional<PsfFinding> mutated(const PsfFinding& honest, const PsfFinding* sin2, const PsfExperiment& spec,
                                  const Footprint& footprint, const Mutation& mutation) {
  PsfFinding finding = honest;
  if (const auto wrong = mutated_footprint(mutation, spec.eye, footprint))
    finding.predicted = arcminutes(Ellipse::image_of_disc(wrong->angular, spec.eye.pupil_radius_m));
  else if (std::holds_alternative<mutation::DroppedTangentialTerm>(mutation.kind) && sin2)
    finding.measured = sin2->measured;
  else if (std::holds_alternative<mutation::HalfPixelShift>(mutation.kind))
    finding.measured->centroid_arcmin->x() += 0.5 * *finding.pixel_arcmin;
  else
    return std::nullopt;
  return finding;
}

void add_mutated(std::vector<PsfFinding>& findings, const PsfExperiment& spec, const Footprint& footprint,
                 std::span<const Mutation> mutations) {
  const auto of = [&](RayModel model) {
    const auto found =
        std::find_if(findings.begin(), findings.end(), [&](const PsfFinding& f) { return f.ray_model == model; });
    return found == findings.end() ? nullptr : &*found;
  };
  PsfFinding* matrix = of(RayModel::power_matrix);
  if (!matrix) return;
  const PsfFinding honest = *matrix;
  for (const Mutation& mutation : mutations)
    if (auto other = mutated(honest, of(RayModel::sin2_radial), spec, footprint, mutation))
      matrix->mutated.emplace(mutation.id, std::move(*other));
}

}  // namespace

std::vector<PsfFinding> psf_findings(const PsfExperiment& spec, std::uint64_t seed, std::span<const Mutation> mutations,
                                     const std::filesystem::path& folder, const ProgressFunction& progress) {
  const Footprint footprint = naked_eye_footprint(spec.eye, spec.distance_m);
  // One target, one accommodation: the picture is taken with the one that the eye chose for it.
  Eye eye = spec.eye;
  eye.accommodation = FixedAccommodation{footprint.accommodation_D, spec.eye.stated_focus_distance_m().value_or(0.0)};
  const Ellipse predicted = Ellipse::image_of_disc(footprint.angular, spec.eye.pupil_radius_m);
  const std::vector<Spot> spots = bundles_of(spec, footprint, seed);
  const SpotView view(spec, reach_of(predicted, spots));
  const Scene scene(emitter_ahead(spec.distance_m, view.emitter));

  PsfFinding common;
  common.id = spec.id;
  common.prescription = spec.prescription;
  common.distance_m = spec.distance_m;
  common.pupil_mm = 2e3 * spec.eye.pupil_radius_m;
  common.predicted_file = "psf/" + spec.id + "_predicted.exr";
  common.pixel_arcmin = view.pixel * arcminutes_per_radian;
  common.resolution = static_cast<std::uint64_t>(spec.resolution);
  common.predicted = arcminutes(predicted);
  const Image prediction =
      predicted_spot(spec.eye.pupil_radius_m / view.pixel * footprint.angular, emitter_radius_px, spec.resolution);
  write_exr(folder / common.predicted_file, LayeredImage{{{"", prediction}}, {}});

  std::vector<PsfFinding> findings;
  for (std::size_t k = 0; k < spots.size(); ++k) {
    RenderSettings settings;
    settings.samples_per_pixel = std::max(1, static_cast<int>(spec.samples_per_pixel) / replicate_count);
    settings.max_bounces = 0;
    const Replicates pictures = render_replicates(
        scene, view.pose, eye, spots[k].model, settings, seed, replicate_count,
        [&](double fraction) { progress((static_cast<double>(k) + fraction) / static_cast<double>(spots.size())); });
    const Image mean = pictures.mean();
    PsfFinding finding = common;
    finding.ray_model = spots[k].model;
    finding.file = "psf/" + spec.id + "_" + name_of(spots[k].model) + ".exr";
    finding.measured = measured_spot(pictures, mean, view, 1.0 * settings.samples_per_pixel * replicate_count);
    finding.bundle = arcminutes(spots[k].bundle.ellipse);
    write_exr(folder / finding.file, LayeredImage{{{"", mean}}, {}});
    findings.push_back(std::move(finding));
  }
  add_mutated(findings, spec, footprint, mutations);
  return findings;
}

}  // namespace sturm
