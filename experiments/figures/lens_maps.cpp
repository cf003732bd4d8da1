#include "experiments/figures/lens_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "conoid/tracing/as_worn.h"
#include "experiments/figures/defocus_as_worn.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "lensmodel/units.h"
#include "lensmodel/vertex_power.h"

namespace sturm {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double clear_D = 0.5;  // about what a sharp-sighted observer notices

/// Line of sight from the eye's centre of rotation to the place (x, y) [m] of the back surface; none where that is not
/// on the lens.
std::optional<Eigen::Vector3d> gaze_to(const Spectacles& lens, double x, double y, double rotation_center_m) {
  const auto there = sag(lens.back, x, y);
  if (!there || std::hypot(x, y) > 0.5 * lens.diameter_m) return std::nullopt;
  const Eigen::Matrix3d wearer_from_back = lens.mounting.wearer_from_lens() * lens.mounting.lens_from_back();
  const Eigen::Vector3d way = lens.back_vertex() + wearer_from_back * Eigen::Vector3d(x, y, there->value) -
                              Eigen::Vector3d(0.0, 0.0, rotation_center_m);
  return way.z() < 0.0 ? std::optional<Eigen::Vector3d>(way.normalized()) : std::nullopt;
}

/// Calls visit(row, column, gaze) for every place of the map.
template <class Visit>
void for_places(const Spectacles& lens, double rotation_center_m, Visit&& visit) {
  const double rim = 0.5 * lens.diameter_m;
  for (int row = 0; row < lens_map_samples; ++row)
    for (int column = 0; column < lens_map_samples; ++column) {
      const auto at = [&](int i) { return rim * (2.0 * i / (lens_map_samples - 1) - 1.0); };
      if (const auto gaze = gaze_to(lens, at(column), at(row), rotation_center_m)) visit(row, column, *gaze);
    }
}

LensMap empty_map(const Spectacles& lens, double rotation_center_m, const std::string& title) {
  LensMap map;
  map.title = title;
  map.rim_radius_mm = 0.5 * lens.diameter_m / metres_per_millimetre;
  map.values = Eigen::MatrixXd::Constant(lens_map_samples, lens_map_samples, nothing);
  const LensPath straight = trace(lens, {{0.0, 0.0, rotation_center_m}, {0.0, 0.0, -1.0}});
  if (straight.status == LensStatus::ok) {
    const Eigen::Matrix3d wearer_from_back = lens.mounting.wearer_from_lens() * lens.mounting.lens_from_back();
    map.fitting_cross_mm =
        (wearer_from_back.transpose() * (straight.back_point - lens.back_vertex())).head<2>() / metres_per_millimetre;
  }
  return map;
}

/// Largest step of 0.25 D times a power of two that draws no more than about 16 lines.
double contour_step_for(const Eigen::MatrixXd& values) {
  double largest = 0.0;
  for (const double value : values.reshaped())
    if (std::isfinite(value)) largest = std::fmax(largest, std::abs(value));
  double step = 0.25;
  while (largest > 20.0 * step) step *= 2.0;
  return step;
}

std::optional<PowerMatrix> power_at(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m) {
  const AsWorn worn = as_worn(lens, gaze, rotation_center_m);
  return worn.status == LensStatus::ok ? worn.power : std::nullopt;
}

/// Mean and cylinder of an error over the places of a lens; `error_at(gaze)` has none where nothing comes through.
template <class ErrorAt>
std::vector<LensMap> maps_of_error(const Spectacles& lens, double rotation_center_m,
                                   const std::array<const char*, 2>& titles, ErrorAt&& error_at) {
  LensMap mean = empty_map(lens, rotation_center_m, titles[0]), cylinder = mean;
  cylinder.title = titles[1];
  cylinder.signed_scale = false;
  for_places(lens, rotation_center_m, [&](int row, int column, const Eigen::Vector3d& gaze) {
    const std::optional<PowerMatrix> error = error_at(gaze);
    if (!error) return;
    mean.values(row, column) = error->spherical_equivalent();
    cylinder.values(row, column) = std::hypot(error->xx() - error->yy(), 2.0 * error->xy());
  });
  mean.contour_step = contour_step_for(mean.values);
  cylinder.contour_step = contour_step_for(cylinder.values);
  return {mean, cylinder};
}

}  // namespace

PowerMatrix nominal_power(const SpectaclesSpec& spec, const Source& where) {
  if (spec.made_for) return PowerMatrix::from(*spec.made_for);
  const auto power = vertex_power(*spec.lens).back_vertex;
  if (!power)
    throw InputError(where.file, where.pointer, "a lens whose focal line lies in its back vertex",
                     "a lens with a back vertex power to compare a map with");
  return *power;
}

std::vector<LensMap> as_worn_maps(const Spectacles& lens, const PowerMatrix& nominal, double rotation_center_m) {
  return maps_of_error(lens, rotation_center_m, {"mean power error, as worn", "cylinder of the error, as worn"},
                       [&](const Eigen::Vector3d& gaze) -> std::optional<PowerMatrix> {
                         const auto power = power_at(lens, gaze, rotation_center_m);
                         return power ? std::optional(*power - nominal) : std::nullopt;
                       });
}

std::vector<LensMap> as_worn_difference(const Spectacles& first, const Spectacles& second, double rotation_center_m) {
  return maps_of_error(first, rotation_center_m, {"difference of mean power, as worn", "cylinder of the difference"},
                       [&](const Eigen::Vector3d& gaze) -> std::optional<PowerMatrix> {
                         const auto before = power_at(first, gaze, rotation_center_m),
                                    after = power_at(second, gaze, rotation_center_m);
                         return before && after ? std::optional(*after - *before) : std::nullopt;
                       });
}

LensMap defocus_map(const Spectacles& lens, const PowerMatrix& correction, double rotation_center_m, double distance_m,
                    double amplitude_D) {
  const std::string target = std::isinf(distance_m) ? "far away" : "at " + plain_number(distance_m, 4) + " m";
  LensMap map = empty_map(lens, rotation_center_m, "defocus for targets " + target + "\\ngreen line: blur of 0.5 D");
  map.limit_values = map.values;
  map.limit = clear_D;
  for_places(lens, rotation_center_m, [&](int row, int column, const Eigen::Vector3d& gaze) {
    const auto defocus = defocus_as_worn(lens, correction, gaze, rotation_center_m, distance_m, amplitude_D);
    if (!defocus) return;
    map.values(row, column) = defocus->mean_D;
    (*map.limit_values)(row, column) = defocus->larger_D;
  });
  map.contour_step = contour_step_for(map.values);
  return map;
}

}  // namespace sturm
