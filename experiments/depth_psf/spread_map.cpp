#include "experiments/depth_psf/depth_psf_study.h"
#include "lensmodel/units.h"
#include "stages/psf_stage.h"
#include "wavefront/psf/ray_fan.h"

namespace sturm {

namespace {

constexpr double field_arcmin = 97.0;  // holds the blur of 3 D over 6 mm twice

PsfSpec spec_of(const SpreadMapSpec& map, double pupil_diameter_m) {
  PsfSpec spec;
  spec.eye = Eye::with(Prescription{}, pupil_diameter_m);
  spec.in_focus_nm = map.wavelength_nm;
  spec.models = {PsfModel::Rays, PsfModel::Waves};
  spec.lights = {{"one_wavelength", monochromatic_light(map.wavelength_nm)},
                 {"white", luminance_weighted_light(map.step_nm)}};
  for (const double defocus : map.defocus_D) spec.targets.push_back({std::nullopt, 0.0, defocus});
  spec.energy_shares = {0.5};
  spec.ray_count = usual_ray_count;
  spec.cells_arcmin = {map.cell_arcmin};
  spec.field_arcmin = field_arcmin;
  spec.pixel_arcmin = map.cell_arcmin;
  spec.size_px = 1;
  return spec;
}

}  // namespace

std::vector<SpreadCell> spread_cells(const SpreadMapSpec& map, double pupil_diameter_m) {
  const PsfSpec spec = spec_of(map, pupil_diameter_m);
  const PointSpreads found = point_spreads(spec, "depth_psf_study");
  std::vector<SpreadCell> cells;
  for (const PsfDistance& distance : found.distances)
    cells.push_back({.light = spec.lights[distance.light].id,
                     .pupil_mm = 1e3 * pupil_diameter_m,
                     .defocus_D = map.defocus_D[distance.target],
                     .total_variation = distance.total_variation.front()});
  for (const MeasuredSpread& spread : found.spreads) {
    SpreadCell& cell = cells[spread.light * map.defocus_D.size() + spread.target];
    Number& radius = spread.model == PsfModel::Rays ? cell.rays_r50_arcmin : cell.waves_r50_arcmin;
    if (const auto& measured = spread.radii_about_chief_ray.front()) radius = *measured * arcminutes_per_radian;
  }
  return cells;
}

}  // namespace sturm
