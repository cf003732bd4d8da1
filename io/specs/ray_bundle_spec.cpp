#include "io/specs/ray_bundle_spec.h"

#include <nlohmann/json.hpp>
#include <string>

#include "io/files/error.h"
#include "io/specs/words.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// Points on the rim may have been rounded when they were written.
constexpr double rim_tolerance = 1e-9;

std::vector<Eigen::Vector2d> read_points(const Json& points, const Source& where, double pupil_radius_m) {
  std::vector<Eigen::Vector2d> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d point =
        metres_per_millimetre * Eigen::Vector2d(points[i][0].get<double>(), points[i][1].get<double>());
    if (!(point.norm() <= pupil_radius_m * (1.0 + rim_tolerance)))
      (where / i).fail(points[i], "a point in the pupil, at most " +
                                      Json(pupil_radius_m / metres_per_millimetre).dump() + " mm from its centre");
    result.push_back(point);
  }
  return result;
}

}  // namespace

RayBundleSpec read_ray_bundle(const Json& value, const Source& where, double pupil_radius_m) {
  RayBundleSpec spec;
  if (value.is_null()) return spec;
  const bool quadrature = value.contains("quadrature"), points = value.contains("pupil_points_mm");
  if (quadrature && points)
    (where / "pupil_points_mm").fail(value["pupil_points_mm"], "either \"quadrature\" or \"pupil_points_mm\"");
  if (quadrature || points)
    for (const char* key : {"count", "replicates", "sequence", "sampling", "rings"})
      if (value.contains(key))
        (where / key)
            .fail(value[key],
                  std::string("no \"") + key + "\" beside \"" + (quadrature ? "quadrature" : "pupil_points_mm") + "\"");
  spec.count = value.value("count", spec.count);
  spec.replicates = value.value("replicates", spec.replicates);
  spec.sequence = word_or(value, "sequence", spec.sequence, where, sequence_words);
  spec.sampling = read_pupil_sampling(value, where);
  if (quadrature)
    spec.quadrature =
        QuadratureSpec{value["quadrature"]["radial"].get<int>(), value["quadrature"]["azimuthal"].get<int>()};
  if (points) spec.pupil_points_m = read_points(value["pupil_points_mm"], where / "pupil_points_mm", pupil_radius_m);
  return spec;
}

}  // namespace sturm
