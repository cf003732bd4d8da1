#include "compare/psf/psf_comparison.h"

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

PsfSummary summary_of(const PointSpread& spread, const std::vector<double>& radii) {
  PsfSummary s;
  s.centroid = spread.centroid();
  s.covariance = spread.covariance();
  s.radius_50 = encircled_energy_radius(spread, 0.5);
  s.radius_80 = encircled_energy_radius(spread, 0.8);
  s.encircled_energy = encircled_energy(spread, radii);
  for (std::size_t d = 0; d < report_directions_deg.size(); ++d)
    for (const double f : report_frequencies_cpd)
      s.mtf[d].push_back(modulation_transfer(spread, f, report_directions_deg[d]));
  return s;
}

}  // namespace

PsfComparison compare_psfs(const PointSpread& test, const PointSpread& reference, double cell_arcmin) {
  PsfComparison c;
  constexpr int radii = 20;
  const double half_light = encircled_energy_radius(reference, 0.5).value;
  for (int i = 1; i <= radii && half_light > 0.0; ++i) c.radii_arcmin.push_back(half_light * 2.0 * i / radii);
  c.test = summary_of(test, c.radii_arcmin);
  c.reference = summary_of(reference, c.radii_arcmin);
  c.shift = c.test.centroid - c.reference.centroid;
  const PointSpread a = test.centred(), b = reference.centred();
  c.total_variation = total_variation(a, b, cell_arcmin);
  c.cell_arcmin = cell_arcmin;
  c.sliced_wasserstein = sliced_wasserstein(a, b);
  for (std::size_t d = 0; d < c.test.mtf.size(); ++d)
    for (std::size_t k = 0; k < c.test.mtf[d].size(); ++k) {
      const auto &p = c.test.mtf[d][k], &q = c.reference.mtf[d][k];
      if (p && q) c.largest_mtf_difference = std::max(c.largest_mtf_difference, std::abs(p->value - q->value));
    }
  return c;
}

}  // namespace sturm
