#include "stages/psf_stage.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "lensmodel/units.h"
#include "wavefront/psf/transfer.h"
#include "wavefront/psf/wave_measures.h"

namespace sturm {

namespace {

bool has(const PsfSpec& spec, PsfModel model) {
  return std::find(spec.models.begin(), spec.models.end(), model) != spec.models.end();
}

/// An odd number of cells that fill the field of the comparison.
int cells_across(const PsfSpec& spec, double cell_arcmin) {
  return 2 * static_cast<int>(spec.field_arcmin / cell_arcmin / 2.0) + 1;
}

/// One light and target of a spec.
struct Question {
  const PsfSpec& spec;
  const PupilWave& pupil;
  const Light& light;
  double vergence_D;
  RayMoments moments;

  /// |OTF| in all directions and frequencies.
  template <class Transfer>
  std::vector<std::vector<double>> mtf(const Transfer& transfer) const {
    std::vector<std::vector<double>> rows;
    for (const double direction : spec.directions_deg) {
      const auto [sine, cosine] = sine_cosine_of_degrees(direction);
      rows.emplace_back();
      for (const double cpd : spec.frequencies_cpd)
        rows.back().push_back(std::abs(transfer(cpd / radians_per_degree * Eigen::Vector2d(cosine, sine))));
    }
    return rows;
  }

  MeasuredSpread start(PsfModel model) const {
    MeasuredSpread spread{};
    spread.model = model;
    spread.centroid = moments.centroid;
    return spread;
  }

  MeasuredSpread rays(const RayFan& fan) const {
    MeasuredSpread spread = start(PsfModel::Rays);
    spread.covariance = moments.covariance;
    spread.mtf = mtf([&](const Eigen::Vector2d& f) { return ray_transfer(fan, vergence_D, f); });
    for (const double share : spec.energy_shares) {
      spread.radii_about_chief_ray.push_back(ray_radius(fan, vergence_D, Eigen::Vector2d::Zero(), share));
      spread.radii_about_centroid.push_back(ray_radius(fan, vergence_D, moments.centroid, share));
    }
    spread.picture = cells_of(fan, vergence_D, spec.pixel_arcmin / arcminutes_per_radian, spec.size_px);
    return spread;
  }

  MeasuredSpread waves(const WavePsf& psf) const {
    MeasuredSpread spread = start(PsfModel::Waves);
    spread.strehl_origin = psf.strehl_origin;
    spread.strehl_peak = psf.strehl_peak;
    spread.peak = psf.peak;
    spread.sampling = psf.sampling;
    spread.visual_strehl = visual_strehl(psf, pupil, light);
    spread.mtf = mtf([&](const Eigen::Vector2d& f) { return wave_transfer(pupil, light, vergence_D, f); });
    const WaveEnergy about_chief_ray(psf, Eigen::Vector2d::Zero()), about_centroid(psf, moments.centroid);
    for (const double share : spec.energy_shares) {
      spread.radii_about_chief_ray.push_back(about_chief_ray.radius(share));
      spread.radii_about_centroid.push_back(about_centroid.radius(share));
    }
    spread.picture = cells_of(psf, spec.pixel_arcmin / arcminutes_per_radian, spec.size_px);
    return spread;
  }

  std::vector<double> distances(const RayFan& fan, const WavePsf& psf) const {
    std::vector<double> result;
    for (const double cell_arcmin : spec.cells_arcmin) {
      const double cell = cell_arcmin / arcminutes_per_radian;
      const int side = cells_across(spec, cell_arcmin);
      result.push_back(total_variation(cells_of(fan, vergence_D, cell, side), cells_of(psf, cell, side)));
    }
    return result;
  }
};

}  // namespace

PointSpreads point_spreads(const PsfSpec& spec, const std::string& file) {
  PupilWave pupil = PupilWave::of(spec.eye, spec.in_focus_nm);
  if (spec.examiner_frame) pupil = pupil.mirrored();
  // All samplings before any work, so that a wave that would alias is refused at once.
  std::vector<WaveSampling> samplings;
  if (has(spec, PsfModel::Waves)) {
    for (const NamedLight& light : spec.lights)
      for (const PsfTarget& target : spec.targets) try {
          samplings.push_back(wave_sampling(pupil, light.light, target.vergence_D, spec.wave_grid));
        } catch (const AliasedSampling& error) {
          throw InputError(file, spec.wave_grid ? "/waves/grid" : "/models", error.what(),
                           "waves that a grid can hold: a smaller pupil, less defocus, a larger grid (up to 4096), or "
                           "\"rays\" alone");
        }
  }
  PointSpreads result;
  for (std::size_t l = 0; l < spec.lights.size(); ++l) {
    const Light& light = spec.lights[l].light;
    std::optional<RayFan> fan;
    if (has(spec, PsfModel::Rays)) fan.emplace(pupil, light, spec.ray_count);
    for (std::size_t t = 0; t < spec.targets.size(); ++t) {
      const double vergence = spec.targets[t].vergence_D;
      const Question question{spec, pupil, light, vergence, ray_moments(pupil, light, vergence)};
      std::optional<WavePsf> psf;
      if (has(spec, PsfModel::Waves)) psf = wave_psf(pupil, light, vergence, samplings[l * spec.targets.size() + t]);
      for (const PsfModel model : spec.models) {
        result.spreads.push_back(model == PsfModel::Rays ? question.rays(*fan) : question.waves(*psf));
        result.spreads.back().light = l;
        result.spreads.back().target = t;
      }
      if (fan && psf) result.distances.push_back({l, t, question.distances(*fan, *psf)});
    }
  }
  return result;
}

}  // namespace sturm
