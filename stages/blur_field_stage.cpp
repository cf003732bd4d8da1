#include "stages/blur_field_stage.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/json/values.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"
#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/cameras/camera_pose.h"
#include "pathtrace/scene/scene_import.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

FieldGrid grid_of(const BlurFieldSpec& spec) {
  return {spec.nx,
          spec.ny,
          spec.nz,
          std::tan(0.5 * spec.hfov),
          std::tan(0.5 * spec.vfov),
          spec.near_vergence_D,
          spec.far_vergence_D};
}

/// Looks into every cell of the field and marks the voxels that a look-up at what is seen there reads.
VoxelMask visible_voxels(const BlurFieldSpec& spec, const FieldGrid& grid) {
  const Scene scene(build_scene(spec.visible->scene));
  const LineOfSight& sight = spec.visible->sight;
  const Eigen::Matrix3d world_from_wearer =
      head_axes({.position = sight.position, .look_at = sight.look_at, .up = sight.up});

  const int looks = spec.visible->looks_per_cell, columns = (grid.nx - 1) * looks, rows = (grid.ny - 1) * looks;
  const auto ndc = [](int at, int count) { return (2.0 * at + 1.0) / count - 1.0; };
  std::vector<double> vergences(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                                -1.0);  // −1: nothing is seen
  tbb::parallel_for(0, rows, [&](int row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector3d gaze = grid.line_of_sight(ndc(column, columns), -ndc(row, rows));
      LightRay ray{turned_pupil_center(gaze, spec.eye.rotation_center_m), gaze};
      if (spec.spectacles) {
        const LensPath path = trace(*spec.spectacles, ray);
        if (path.status != LensStatus::ok) continue;
        ray = path.exit;
      }
      vergences[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)] =
          vergence_of(distance_along(
              scene, {sight.position + world_from_wearer * ray.origin, world_from_wearer * ray.direction}));
    }
  });
  VoxelMask mask(grid);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      mask.add_look_up(ndc(column, columns), -ndc(row, rows),
                       vergences[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                                 static_cast<std::size_t>(column)]);
  return mask;
}

/// Largest error that the interpolation between lines of sight makes: in the middle of each cell, at the nearest and
/// the farthest distance, relaxed; as blur [D] (rad/m), the larger singular value of the difference.
Json interpolation_error(const BlurFieldSpec& spec, const DepthAnalyticField& field) {
  const FieldGrid& grid = field.grid();
  const Spectacles* lens = spec.spectacles ? &*spec.spectacles : nullptr;
  FieldGrid middles = grid;  // a grid whose nodes are the middles of the cells
  middles.nx = grid.nx - 1;
  middles.ny = grid.ny - 1;
  if (middles.nx < 2 || middles.ny < 2) return nullptr;
  middles.tan_half_width *= 1.0 - 1.0 / (grid.nx - 1);
  middles.tan_half_height *= 1.0 - 1.0 / (grid.ny - 1);
  const TracedDirections exact = trace_directions(lens, spec.eye.rotation_center_m, middles);
  const Eigen::Matrix2d slopes = spec.eye.slope_matrix(0.0).matrix();
  double worst = 0.0, squares = 0.0;
  std::size_t count = 0;
  for (int j = 0; j < middles.ny; ++j)
    for (int i = 0; i < middles.nx; ++i)
      for (const double vergence : {grid.near_vergence_D, grid.far_vergence_D}) {
        const SpectacleConoid& conoid = exact.conoids[middles.index(i, j)];
        const auto stored = field.angular_footprint(static_cast<float>((2.0 * i + 1.0) / middles.nx - 1.0),
                                                    static_cast<float>(1.0 - (2.0 * j + 1.0) / middles.ny),
                                                    static_cast<float>(vergence), 0.0f);
        if (conoid.status != LensStatus::ok || !stored) continue;
        const double error =
            Ellipse::image_of_disc(stored->cast<double>() - conoid.angular_footprint(slopes, vergence), 1.0).semi_major;
        worst = std::max(worst, error);
        squares += error * error;
        ++count;
      }
  if (count == 0) return nullptr;
  return {{"largest_D", worst}, {"rms_D", std::sqrt(squares / static_cast<double>(count))}};
}

Json direction_summary(const DirectionCounters& c, const FieldGrid& grid) {
  return {{"total", grid.directions()},
          {"traced", c.traced},
          {"mirrored", c.mirrored},
          {"skipped_beyond_rim", c.beyond_rim},
          {"usable", c.usable},
          {"missed_lens", c.missed_lens},
          {"total_internal_reflection", c.total_internal_reflection},
          {"no_convergence", c.no_convergence}};
}

Json voxel_summary(const VoxelField& field) {
  return {{"total", field.grid().voxels()},
          {"stored", field.stored_voxels()},
          {"skipped_empty", field.grid().voxels() - field.stored_voxels()},
          {"undefined", field.undefined_count()},
          {"memory_bytes", field.memory_bytes()}};
}

}  // namespace

TracedDirections field_directions(const BlurFieldSpec& spec) {
  return trace_directions(spec.spectacles ? &*spec.spectacles : nullptr, spec.eye.rotation_center_m, grid_of(spec),
                          {spec.skip_rim, spec.skip_symmetry});
}

BlurField compute_blur_field(const BlurFieldSpec& spec) {
  const Spectacles* lens = spec.spectacles ? &*spec.spectacles : nullptr;
  BlurField field;
  field.grid = grid_of(spec);
  Stopwatch watch;
  std::optional<VoxelMask> visible;
  if (spec.visible && spec.voxels && spec.skip_empty_voxels) {
    visible = visible_voxels(spec, field.grid);
    field.seconds["visibility"] = watch.lap();
  }
  field.directions = field_directions(spec);
  field.seconds["chief_rays"] = watch.lap();
  if (spec.depth_analytic) {
    field.analytic.emplace(field.grid, field.directions, spec.eye.correction);
    field.seconds["depth_analytic"] = watch.lap();
  }
  if (spec.voxels) {
    field.voxels.emplace(
        fill_voxels(lens, spec.eye, field.grid, field.directions, spec.method, visible ? &*visible : nullptr));
    field.seconds["voxels"] = watch.lap();
  }
  field.summary = {
      {"directions", direction_summary(field.directions.counters, field.grid)},
      {"depth_analytic", field.analytic ? Json{{"memory_bytes", field.analytic->memory_bytes()}} : Json(nullptr)},
      {"voxels", field.voxels ? voxel_summary(*field.voxels) : Json(nullptr)},
      {"interpolation_error",
       interpolation_error(spec, field.analytic
                                     ? *field.analytic
                                     : DepthAnalyticField(field.grid, field.directions, spec.eye.correction))}};
  return field;
}

std::vector<EllipseLayer> ellipse_layers(const BlurFieldSpec& spec, const TracedDirections& directions) {
  std::vector<EllipseLayer> layers;
  for (const double distance : spec.layers_m) {
    const double vergence = vergence_of(distance);
    EllipseLayer layer{distance, {}};
    for (const SpectacleConoid& conoid : directions.conoids) {
      if (conoid.status != LensStatus::ok || !(conoid.chief_ray.direction.z() < 0.0)) continue;
      const Eigen::Matrix2d slopes = spec.eye.slope_matrix(accommodation_through(conoid, spec.eye, vergence)).matrix();
      const Eigen::Matrix2d on_picture = picture_jacobian(conoid.chief_ray.direction, conoid.exit.e1, conoid.exit.e2) *
                                         conoid.angular_footprint(slopes, vergence);
      layer.ellipses.push_back(
          {picture_point(conoid.chief_ray.direction), Ellipse::image_of_disc(on_picture, spec.eye.pupil_radius_m)});
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace sturm
