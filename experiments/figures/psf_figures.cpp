#include "experiments/figures/psf_figures.h"

#include <limits>

#include "lensmodel/units.h"
#include "stages/psf_stage.h"
#include "wavefront/psf/ray_fan.h"

namespace sturm {

namespace {

double distance_of(const PsfTarget& target) {
  return target.distance_m.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

std::vector<SpotDiagram> spot_diagrams(const PsfSpec& spec, std::size_t rays) {
  const Light& light = spec.lights.front().light;
  const PupilWave pupil = PupilWave::of(spec.eye, spec.in_focus_nm);
  const RayFan fan(pupil, light, rays);
  std::vector<SpotDiagram> spots;
  for (const PsfTarget& target : spec.targets) {
    SpotDiagram spot;
    spot.distance_m = distance_of(target);
    fan.for_each(target.vergence_D, rays,
                 [&](const Eigen::Vector2d& angle, double) { spot.points.push_back(arcminutes_per_radian * angle); });
    const RayMoments moments = ray_moments(pupil, light, target.vergence_D);
    spot.centroid = arcminutes_per_radian * moments.centroid;
    spot.ellipse = Ellipse::of_second_moments(arcminutes_per_radian * arcminutes_per_radian * moments.covariance);
    spots.push_back(std::move(spot));
  }
  return spots;
}

std::vector<MtfCurve> mtf_curves(const PsfSpec& spec, const std::string& file) {
  std::vector<MtfCurve> curves;
  for (const MeasuredSpread& spread : point_spreads(spec, file).spreads) {
    if (spread.light != 0) continue;
    for (std::size_t d = 0; d < spec.directions_deg.size(); ++d)
      curves.push_back({distance_of(spec.targets[spread.target]), spec.directions_deg[d],
                        std::string(psf_model_words.word_of(spread.model)), spec.frequencies_cpd, spread.mtf[d]});
  }
  return curves;
}

}  // namespace sturm
