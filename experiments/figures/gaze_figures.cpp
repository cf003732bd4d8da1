#include "experiments/figures/gaze_figures.h"

#include <cmath>

#include "conoid/tracing/as_worn.h"
#include "experiments/figures/blur_curve.h"
#include "experiments/figures/conoid_ellipses.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"
#include "reports/plots/plot_style.h"

namespace sturm {

namespace {

constexpr double highest_deg = 20.0, lowest_deg = -40.0, search_deg = 15.0, widest_deg = 45.0, azimuth_step_deg = 0.125;

/// What a lens gives in excess at one gaze.
struct Excess {
  double mean_D, cylinder_D;
};

class Row {
 public:
  Row(const Spectacles& lens, const PowerMatrix& nominal, double rotation_center_m, double elevation_deg)
      : lens_(lens), nominal_(nominal), rotation_center_m_(rotation_center_m), elevation_deg_(elevation_deg) {}

  std::optional<Excess> at(double azimuth_deg) const {
    const AsWorn worn =
        as_worn(lens_, gaze_direction(radians_per_degree * azimuth_deg, radians_per_degree * elevation_deg_),
                rotation_center_m_);
    if (worn.status != LensStatus::ok || !worn.power) return std::nullopt;
    const PowerMatrix error = *worn.power - nominal_;
    return Excess{error.spherical_equivalent(), std::hypot(error.xx() - error.yy(), 2.0 * error.xy())};
  }

  /// How far the cylinder stays below the limit to one side (`step` with its sign) of `azimuth_deg`.
  double reach(double azimuth_deg, double step, double limit_D) const {
    double last = azimuth_deg;
    for (double azimuth = azimuth_deg; std::abs(azimuth) <= widest_deg; azimuth += step) {
      const auto excess = at(azimuth);
      if (!excess || excess->cylinder_D > limit_D) break;
      last = azimuth;
    }
    return std::abs(last - azimuth_deg);
  }

 private:
  const Spectacles& lens_;
  const PowerMatrix& nominal_;
  double rotation_center_m_, elevation_deg_;
};

CorridorPlace place_of(const Row& row, double elevation_deg, double limit_D) {
  CorridorPlace place;
  place.elevation_deg = elevation_deg;
  const int steps = static_cast<int>(search_deg / azimuth_step_deg);
  for (int i = -steps; i <= steps; ++i)
    if (const auto excess = row.at(azimuth_step_deg * i);
        excess && (!place.astigmatism_D || excess->cylinder_D < *place.astigmatism_D)) {
      place.azimuth_deg = azimuth_step_deg * i;
      place.addition_D = excess->mean_D;
      place.astigmatism_D = excess->cylinder_D;
    }
  if (place.azimuth_deg)
    place.width_deg = row.reach(*place.azimuth_deg, azimuth_step_deg, limit_D) +
                      row.reach(*place.azimuth_deg, -azimuth_step_deg, limit_D);
  if (place.width_deg > 2.0 * search_deg) place.azimuth_deg.reset();  // no corridor yet: nearly the same everywhere
  return place;
}

}  // namespace

EllipseField ellipse_field(const WornEye& worn, const std::string& name, double distance_m, const GazeGrid& gazes,
                           double clear_D) {
  EllipseField field{
      name + ", target " + distance_words(distance_m), {}, gazes.step_deg, clear_semi_axis_arcmin(worn.eye, clear_D)};
  std::vector<Target> targets;
  const int steps = static_cast<int>(std::floor(gazes.reach_deg / gazes.step_deg + 1e-9));
  for (int up = steps; up >= -steps; --up)
    for (int right = -steps; right <= steps; ++right) {
      field.spots.push_back({gazes.step_deg * right, gazes.step_deg * up, std::nullopt});
      targets.push_back(
          {radians_per_degree * gazes.step_deg * right, radians_per_degree * gazes.step_deg * up, distance_m});
    }
  const std::vector<BlurAtDistance> ellipses = conoid_ellipses(worn, targets);
  for (std::size_t i = 0; i < ellipses.size(); ++i)
    if (ellipses[i].semi_major_arcmin)
      field.spots[i].ellipse =
          Ellipse{*ellipses[i].semi_major_arcmin, *ellipses[i].semi_minor_arcmin, ellipses[i].orientation_deg};
  return field;
}

CorridorProfile corridor_profile(const Spectacles& lens, const PowerMatrix& nominal, double rotation_center_m,
                                 const std::string& name, double limit_D) {
  CorridorProfile profile{name, {}, limit_D};
  for (double elevation = highest_deg; elevation >= lowest_deg; elevation -= 1.0)
    profile.places.push_back(place_of(Row(lens, nominal, rotation_center_m, elevation), elevation, limit_D));
  return profile;
}

}  // namespace sturm
