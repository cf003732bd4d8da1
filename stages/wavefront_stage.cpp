#include "stages/wavefront_stage.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double rounding = 1e-9;  // of places at the rim, relative

[[noreturn]] void fail(const WavefrontQuery& query, const std::string& value, const std::string& expected) {
  throw InputError(query.file, "", value, expected);
}

/// Sorts the points into those within the pupil and those outside. Heights come on rectangular grids, whose corners
/// need not lie within.
void split(const WavefrontQuery& query, FittedWavefront& fitted) {
  const double limit = query.pupil_radius_m * (1.0 + rounding);
  for (const SensorPoint& point : query.table.points) {
    if (point.point.norm() <= limit) {
      fitted.points.push_back(point);
      continue;
    }
    if (!query.table.heights && !query.drop_outside)
      throw InputError(query.file, "line " + std::to_string(point.line),
                       formatted("a spot %.4g mm from the pupil's centre", point.point.norm() / metres_per_millimetre),
                       formatted("spots within the pupil's radius of %.4g mm (--pupil-mm, --center), or --drop-outside",
                                 query.pupil_radius_m / metres_per_millimetre));
    fitted.outside.push_back(point);
  }
  if (fitted.points.empty()) fail(query, "no measurement within the pupil", "some: see --pupil-mm and --center");
}

/// The median distance of points from their nearest neighbour [m].
double spacing(const std::vector<SensorPoint>& points) {
  std::vector<double> nearest;
  for (const SensorPoint& a : points) {
    double least = HUGE_VAL;
    for (const SensorPoint& b : points)
      if (&a != &b && b.point != a.point) least = std::min(least, (a.point - b.point).squaredNorm());
    nearest.push_back(std::sqrt(least));
  }
  std::nth_element(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2), nearest.end());
  return nearest[nearest.size() / 2];
}

/// Polynomials grow without bound beyond the points that they were fitted to.
void require_measured_pupil(const WavefrontQuery& query, const std::vector<SensorPoint>& points) {
  constexpr double stretch = 1.25;
  constexpr std::size_t most_compared = 4000;  // a dense grid reaches as far as its points
  double reach = 0.0;
  for (const SensorPoint& point : points) reach = std::max(reach, point.point.norm());
  if (points.size() > 1 && points.size() <= most_compared) reach += spacing(points);
  if (std::isfinite(reach) && query.pupil_radius_m > stretch * reach)
    fail(query, formatted("a pupil of %.4g mm", 2.0 * query.pupil_radius_m / metres_per_millimetre),
         formatted("a pupil that was measured: the points reach to a diameter of %.4g mm",
                   2.0 * reach / metres_per_millimetre));
}

ModalProblem problem_of(const WavefrontQuery& query, const std::vector<SensorPoint>& points, int radial_order) {
  std::vector<int> modes = modes_of_slopes(radial_order);
  if (query.table.heights) {
    modes.insert(modes.begin(), 0);
    std::vector<HeightSample> samples;
    for (const SensorPoint& p : points) samples.push_back({p.point, p.height});
    return height_problem(samples, modes, query.pupil_radius_m);
  }
  std::vector<SlopeSample> samples;
  for (const SensorPoint& p : points) samples.push_back({p.point, p.slope});
  return slope_problem(samples, modes, query.pupil_radius_m, query.lenslet_m);
}

}  // namespace

std::vector<double> FittedWavefront::coefficients_um() const {
  std::vector<double> c(static_cast<std::size_t>(fit.modes.back()) + 1, 0.0);
  for (std::size_t i = 0; i < fit.modes.size(); ++i)
    c[static_cast<std::size_t>(fit.modes[i])] = fit.coefficients[static_cast<Eigen::Index>(i)] / metres_per_micrometre;
  return c;
}

FittedWavefront fit_wavefront(const WavefrontQuery& query) {
  FittedWavefront fitted;
  split(query, fitted);
  require_measured_pupil(query, fitted.points);
  const auto count = static_cast<int>(fitted.points.size());
  const char* what = query.table.heights ? "heights" : "spots";
  try {
    if (!query.radial_order) {
      fitted.choice = choose_order([&](int order) { return problem_of(query, fitted.points, order); }, count);
      fitted.radial_order = fitted.choice->radial_order;
    } else {
      fitted.radial_order = *query.radial_order;
    }
    const ModalProblem problem = problem_of(query, fitted.points, fitted.radial_order);
    const auto modes = static_cast<int>(problem.modes.size());
    if (count < modes)
      fail(query, formatted("%d %s within the pupil", count, what),
           formatted("at least %d, one for each mode up to order %d", modes, fitted.radial_order));
    fitted.fit = query.keep_spurious ? fit_modes(problem, std::vector<bool>(static_cast<std::size_t>(count), true))
                                     : fit_modes_robustly(problem);
  } catch (const UndeterminedFit& error) {
    fail(query, error.what(), formatted("%s all over the pupil, at least as many as modes; or a lower --order", what));
  }
  return fitted;
}

}  // namespace sturm
