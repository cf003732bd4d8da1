#include "conoid/blur_field/traced_directions.h"

#include "conoid/threads/parallel_for.h"
#include "lensmodel/gaze.h"

namespace sturm {

namespace {

bool has_two_mirrors(const Surface& surface) {
  if (const auto* torus = std::get_if<TorusSurface>(&surface))
    return torus->sweep_direction().x() == 0.0 || torus->sweep_direction().y() == 0.0;
  return std::holds_alternative<SphereSurface>(surface) || std::holds_alternative<ConicSurface>(surface);
}

/// What one direction did; the counters add up in the order of the directions.
enum class Way : std::uint8_t { traced, mirrored, beyond_rim };

SpectacleConoid naked_conoid(const Eigen::Vector3d& gaze, double rotation_center_m) {
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  SpectacleConoid conoid;
  conoid.status = LensStatus::ok;
  conoid.chief_ray = {turned_pupil_center(gaze, rotation_center_m), gaze};
  conoid.exit = RayTransfer::start(gaze, turn.col(0), turn.col(1));
  return conoid;
}

/// The same conoid seen in mirrors: `x` and `y` are −1 where that axis is turned round.
SpectacleConoid mirrored(const SpectacleConoid& original, double x, double y) {
  SpectacleConoid image = original;
  const Eigen::Vector3d space(x, y, 1.0);
  const Eigen::Vector2d plane(x, y);
  const auto point = [&](Eigen::Vector3d& v) { v = v.cwiseProduct(space); };
  const auto map = [&](Eigen::Matrix2d& m) { m = plane.asDiagonal() * m * plane.asDiagonal(); };
  point(image.chief_ray.origin);
  point(image.chief_ray.direction);
  RayTransfer& t = image.exit;
  point(t.direction);
  point(t.e1);
  point(t.e2);
  t.e1 *= x;  // the mirror turns the frame's own axes round as well
  t.e2 *= y;
  map(t.offset_from_offset);
  map(t.offset_from_slope);
  map(t.slope_from_offset);
  map(t.slope_from_slope);
  return image;
}

struct Tracer {
  const Spectacles* lens;
  double rotation_center;
  const FieldGrid& grid;
  bool use_rim;

  Way operator()(int i, int j, SpectacleConoid& conoid) const {
    const Eigen::Vector3d gaze = grid.line_of_sight(grid.ndc_x(i), grid.ndc_y(j));
    if (!lens) {
      conoid = naked_conoid(gaze, rotation_center);
      return Way::traced;
    }
    if (use_rim && !may_meet(*lens, {turned_pupil_center(gaze, rotation_center), gaze})) {
      conoid.status = LensStatus::missed_lens;
      return Way::beyond_rim;
    }
    conoid = trace_conoid(*lens, gaze, rotation_center);
    return Way::traced;
  }
};

DirectionCounters counted(const std::vector<SpectacleConoid>& conoids, const std::vector<Way>& ways) {
  DirectionCounters counters;
  for (std::size_t k = 0; k < conoids.size(); ++k) {
    counters.traced += ways[k] == Way::traced;
    counters.mirrored += ways[k] == Way::mirrored;
    counters.beyond_rim += ways[k] == Way::beyond_rim;
    counters.usable += conoids[k].status == LensStatus::ok;
    counters.missed_lens += conoids[k].status == LensStatus::missed_lens;
    counters.total_internal_reflection += conoids[k].status == LensStatus::total_internal_reflection;
    counters.no_convergence += conoids[k].status == LensStatus::no_convergence;
  }
  return counters;
}

}  // namespace

bool has_two_mirrors(const Spectacles& lens) {
  return lens.mounting.straight() && !lens.mounting.has_wedge() && has_two_mirrors(lens.back) &&
         has_two_mirrors(lens.front);
}

TracedDirections trace_directions(const Spectacles* lens, double rotation_center_m, const FieldGrid& grid,
                                  const DirectionShortcuts& shortcuts) {
  TracedDirections result;
  result.conoids.resize(grid.directions());
  std::vector<Way> ways(grid.directions(), Way::traced);
  const Tracer trace{lens, rotation_center_m, grid, shortcuts.rim};
  const bool mirrors = lens && shortcuts.symmetry && has_two_mirrors(*lens);
  const int rows = mirrors ? (grid.ny + 1) / 2 : grid.ny, columns = mirrors ? (grid.nx + 1) / 2 : grid.nx;
  parallel_for(0, rows, [&](int j) {
    for (int i = 0; i < columns; ++i) {
      const std::size_t at = grid.index(i, j);
      ways[at] = trace(i, j, result.conoids[at]);
    }
    if (!mirrors) return;
    const int opposite_row = grid.ny - 1 - j;
    for (int i = 0; i < columns; ++i) {
      const int opposite = grid.nx - 1 - i;
      const SpectacleConoid& original = result.conoids[grid.index(i, j)];
      const auto put = [&](int to_i, int to_j, double x, double y) {
        const std::size_t at = grid.index(to_i, to_j);
        if (at == grid.index(i, j)) return;
        result.conoids[at] = mirrored(original, x, y);
        ways[at] = Way::mirrored;
      };
      if (opposite != i) put(opposite, j, -1.0, 1.0);
      if (opposite_row != j) put(i, opposite_row, 1.0, -1.0);
      if (opposite != i && opposite_row != j) put(opposite, opposite_row, -1.0, -1.0);
    }
  });
  result.counters = counted(result.conoids, ways);
  return result;
}

}  // namespace sturm
