#include <cmath>
#include <stdexcept>

#include "conoid/blur_field/depth_analytic_field.h"
#include "conoid/blur_field/voxel_fill.h"
#include "conoid/pictures/pixel_rays.h"
#include "pathtrace/cameras/ray_model.h"
#include "viewer/core/from_js.h"
#include "viewer/core/optics.h"
#include "viewer/core/sight_grid.h"
#include "viewer/core/to_js.h"

namespace sturm::viewer {

using emscripten::val;

namespace {

template <class Counters>
val counters_of(const Counters& c) {
  val result = val::object();
  const auto put = [&](const char* key, std::uint64_t value) { result.set(key, static_cast<double>(value)); };
  put("traced", c.traced);
  put("mirrored", c.mirrored);
  put("beyond_rim", c.beyond_rim);
  put("usable", c.usable);
  put("missed_lens", c.missed_lens);
  put("total_internal_reflection", c.total_internal_reflection);
  put("no_convergence", c.no_convergence);
  return result;
}

double number(const val& object, const char* key) {
  return object[key].as<double>();
}

}  // namespace

val Optics::field_analytic(const val& numbers) const {
  const FieldGrid grid = read_grid(numbers);
  const TracedDirections directions = trace_directions(lens(), eye_.rotation_center_m, grid);
  const DepthAnalyticField field(grid, directions, eye_.correction);
  static_assert(sizeof(DepthAnalyticField::Node) == 16 * sizeof(float));
  val result = val::object();
  result.set("nodes",
             val::global("Float32Array")
                 .new_(val(emscripten::typed_memory_view(16 * field.nodes().size(), field.nodes().front().a))));
  result.set("usable", copy_of(field.usable()));
  result.set("counters", counters_of(directions.counters));
  return result;
}

val Optics::field_voxels(const val& numbers) const {
  const FieldGrid grid = read_grid(numbers);
  const TracedDirections directions = trace_directions(lens(), eye_.rotation_center_m, grid);
  VoxelField field = fill_voxels(lens(), eye_, grid, directions);
  std::vector<std::uint8_t> defined;
  defined.reserve(grid.voxels());
  for (std::size_t direction = 0; direction < grid.directions(); ++direction)
    for (int k = 0; k < grid.nz; ++k) defined.push_back(field.defined(direction, k) ? 1 : 0);
  val result = val::object();
  result.set(
      "voxels",
      val::global("Float32Array")
          .new_(val(emscripten::typed_memory_view(grid.voxels() * VoxelField::floats_per_voxel, field.column(0)))));
  result.set("defined", copy_of(defined));
  return result;
}

val Optics::gaze_at(const val& camera, double x_px, double y_px) const {
  const Eigen::Vector2d q = read_camera(camera).slope({x_px, y_px});
  const Eigen::Vector3d gaze = Eigen::Vector3d(q.x(), q.y(), -1.0).normalized();
  val result = val::object();
  result.set("azimuth_rad", std::atan2(gaze.x(), -gaze.z()));
  result.set("elevation_rad", std::asin(gaze.y()));
  return result;
}

val Optics::picture_ellipse(const val& camera, double x_px, double y_px, double vergence_D) const {
  const SightField field(read_camera(camera), eye_, lens_);
  const Eigen::Vector2d place(x_px, y_px);
  const Sight sight = field.at(place);
  if (!sight.reaches) return val::null();
  const Eigen::Matrix2d slopes = field.slopes(sight, vergence_D);
  const Eigen::Matrix2d map = SightNeighbourhood(field, place, sight).picture_map(slopes, vergence_D);
  const Eigen::Matrix2d upright = Eigen::Vector2d(1.0, -1.0).asDiagonal() * map;
  const Ellipse ellipse = Ellipse::image_of_disc(upright, eye_.pupil_radius_m);
  val result = val::object();
  result.set("semi_axes_px", list_of(ellipse.semi_major, ellipse.semi_minor));
  result.set("orientation_deg", number_or_null(ellipse.orientation_deg));
  result.set("map_px_per_m", rows_of(map));
  result.set("accommodation_D", eye_.correction.spherical_equivalent() - 0.5 * slopes.trace());
  return result;
}

val Optics::sights(const val& grid) const {
  const int columns = static_cast<int>(number(grid, "columns")), rows = static_cast<int>(number(grid, "rows"));
  if (!(columns >= 1 && rows >= 1 && columns <= 4096 && rows <= 4096))
    throw std::invalid_argument("a grid of sights has 1 to 4096 columns and rows");
  PicturePlane head;
  head.gaze = read_gaze(grid["gaze"]);
  const Eigen::Vector2d first(number(grid, "first_x"), number(grid, "first_y")),
      step(number(grid, "step_x"), number(grid, "step_y"));
  return copy_of(sight_grid(head, eye_, lens(), {first, step, columns, rows}));
}

val Optics::pixel_rays(const val& camera, int x, int y, int width, int height, const val& vergences_D) const {
  const SightField field(read_camera(camera), eye_, lens_);
  const auto vergences = emscripten::convertJSArrayToNumberVector<double>(vergences_D);
  if (width < 1 || height < 1 || vergences.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw std::invalid_argument("one vergence a pixel");
  std::vector<float> numbers;
  numbers.reserve(32 * vergences.size());
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      PixelRays rays(field, {x + i + 0.5, y + j + 0.5});
      if (!rays.sight.reaches) {
        numbers.insert(numbers.end(), 32, 0.0f);
        continue;
      }
      rays.bend(vergences[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)]);
      rays.append_to(numbers);
      numbers.insert(numbers.end(), {1.0f, 0.0f});
    }
  return copy_of(numbers);
}

val Optics::ray_model(const std::string& name, double accommodation_D, double focus_distance_m,
                      const val& points_m) const {
  const auto model = ray_model_named(name);
  if (!model) throw std::invalid_argument("unknown ray model \"" + name + "\"");
  const EyeRays<float> rays(*model, eye_, accommodation_D, focus_distance_m);
  const auto points = emscripten::convertJSArrayToNumberVector<float>(points_m);
  std::vector<float> slopes;
  std::vector<std::uint8_t> status;
  for (std::size_t k = 0; k + 1 < points.size(); k += 2) {
    const PupilRay<float> ray = rays.through(points[k], points[k + 1]);
    slopes.insert(slopes.end(), {ray.sx, ray.sy});
    status.push_back(static_cast<std::uint8_t>(ray.status));
  }
  val result = val::object();
  result.set("slopes", copy_of(slopes));
  result.set("status", copy_of(status));
  return result;
}

}  // namespace sturm::viewer
