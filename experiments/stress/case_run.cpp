#include "experiments/stress/case_run.h"

#include <cmath>
#include <exception>

#include "conoid/tracing/previous.h"
#include "conoid/tracing/published.h"
#include "experiments/stress/generator.h"
#include "experiments/stress/oracle_checks.h"
#include "experiments/stress/random.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"

namespace sturm::stress {

namespace {

/// Every such case is searched along the whole ray as well, to see that the program took the first crossing; it costs
/// as much as the rest.
constexpr std::uint64_t searched_every = 8;

Prescription prescription_of(const CaseNumbers& n) {
  return {n.sphere_D, n.cylinder_D, n.axis_deg, metres_per_millimetre * n.rx_vertex_distance_mm};
}

bool finite(const Footprint& f) {
  return std::isfinite(f.accommodation_D) && f.angular.allFinite() &&
         (!f.wavefront_curvature || f.wavefront_curvature->allFinite());
}

bool finite(const SpectacleConoid& c) {
  const RayTransfer& r = c.exit;
  return c.chief_ray.origin.allFinite() && c.chief_ray.direction.allFinite() && r.offset_from_offset.allFinite() &&
         r.offset_from_slope.allFinite() && r.slope_from_offset.allFinite() && r.slope_from_slope.allFinite();
}

/// The methods that the paper compares with: numbers or none.
void check_other_methods(CaseRun& run, double vergence_D) {
  const Eye& eye = *run.eye;
  const Spectacles* lens = run.lens ? &*run.lens : nullptr;
  const double a = run.footprint->accommodation_D;
  const auto published = trace_published(eye, a, lens, run.gaze);
  run.published_tried = true;
  run.published_failed = !published;
  const Eigen::Vector3d out = run.conoid ? run.conoid->chief_ray.direction : run.gaze;
  const Eigen::Matrix3d across = smallest_rotation({0.0, 0.0, -1.0}, out);
  if (published)
    run.outcomes.expect(Check::finite, angular_map(*published, across.col(0), across.col(1), vergence_D).allFinite());
  const auto previous = previous_angular_footprint(eye, a, lens, run.gaze, run.numbers.distance_m);
  if (previous) run.outcomes.expect(Check::finite, previous->allFinite());
}

void run_naked(CaseRun& run, double vergence_D) {
  const double a = run.eye->accommodation_for(vergence_D);
  run.footprint = naked_eye_footprint(*run.eye, run.numbers.distance_m, a);
  run.outcomes.expect(Check::finite, finite(*run.footprint));
  const Eigen::Matrix2d expected = run.eye->correction.matrix() + (vergence_D - a) * Eigen::Matrix2d::Identity();
  const double size = run.eye->correction.matrix().norm() + std::abs(vergence_D) + a;
  run.outcomes.record(Check::correction, (run.footprint->angular - expected).norm(), formula_error * size,
                      std::fmax(size, 1.0));
}

/// Where a path met the surfaces: `trace` leaves the points of a lost ray in the lens's frame.
StartingPoints in_wearer_frame(const Spectacles& lens, const LensPath& path) {
  if (path.status == LensStatus::ok) return {path.back_point, path.exit.origin};
  const Eigen::Matrix3d& turn = lens.mounting.wearer_from_lens();
  return {lens.back_vertex() + turn * path.back_point, lens.back_vertex() + turn * path.exit.origin};
}

void run_through_lens(CaseRun& run, std::uint64_t seed, std::uint64_t index, double vergence_D,
                      const ConoidTracer& tracer) {
  const Spectacles& lens = *run.lens;
  const Eye& eye = *run.eye;
  const double center = eye.rotation_center_m;
  const SpectacleConoid conoid = tracer(lens, run.gaze, center);
  run.conoid = conoid;
  std::optional<StartingPoints> start;
  // Where the program met the surfaces the oracle only has to confirm it; a ray that it lost before is searched along
  // its whole way.
  const LensPath path = trace(lens, {turned_pupil_center(run.gaze, center), run.gaze});
  if (path.status == LensStatus::ok || path.status == LensStatus::total_internal_reflection)
    start = in_wearer_frame(lens, path);
  run.oracle = trace_extended(lens, run.gaze, center, start);
  run.bounds = error_bounds(lens, center, *run.oracle);
  check_status(run.outcomes, conoid.status, lens, *run.oracle, *run.bounds);
  if (conoid.status != LensStatus::ok) return run.outcomes.skip_rest(Skip::lost);
  run.outcomes.expect(Check::finite, finite(conoid));
  const double a = accommodation_through(conoid, eye, vergence_D);
  run.footprint = spectacle_footprint(conoid, eye, run.numbers.distance_m, a);
  run.outcomes.expect(Check::finite, finite(*run.footprint));
  if (run.oracle->status != LensStatus::ok) return run.outcomes.skip_rest(Skip::at_the_edge);
  if (index % searched_every == 0) {
    const ExtendedTrace searched = trace_extended(lens, run.gaze, center, std::nullopt);
    const Vec3<Extended> d = searched.exit_point - run.oracle->exit_point;
    const bool same = searched.status == LensStatus::ok &&
                      dot(d, d) < 1e-24L;  // the search may pass two crossings closer than its steps
    if (!same && searched.status == LensStatus::ok) run.outcomes.expect(Check::status, false);
  }

  const Eigen::Matrix2d slopes = eye.slope_matrix(a).matrix();
  check_against_oracle(run.outcomes, conoid, *run.oracle, *run.bounds, slopes, vergence_D);
  const Traced traced{run.numbers, eye, lens, run.gaze, conoid, *run.bounds, *run.oracle, slopes, vergence_D};
  Random random(~seed, index);
  check_symplectic(run.outcomes, traced);
  check_split(run.outcomes, traced, random.unit());
  check_turned(run.outcomes, traced, tracer, random.uniform(-180.0, 180.0));
  check_scaled(run.outcomes, traced, tracer, random.log_uniform(0.1, 10.0));
  check_mirrored(run.outcomes, traced, tracer);
  check_five_variables(run.outcomes, traced);
  check_accommodation(run.outcomes, traced);
  check_infinity(run.outcomes, traced);
}

/// A maker that needs the prescription as it stands, with the case's lens around it.
void check_forms(CaseRun& run) {
  if (!run.numbers.lens) return check_transposed(run.outcomes, prescription_of(run.numbers), nullptr);
  const LensNumbers& n = *run.numbers.lens;
  const SingleVisionDesign design{4.0, metres_per_millimetre * n.center_thickness_mm, n.refractive_index,
                                  metres_per_millimetre * n.vertex_distance_mm, metres_per_millimetre * n.diameter_mm};
  check_transposed(run.outcomes, prescription_of(run.numbers), &design);
}

}  // namespace

CaseRun run_case(std::uint64_t seed, std::uint64_t index, const FreeFormLenses& free_forms,
                 const ConoidTracer& tracer) {
  CaseRun run;
  try {
    run.numbers = draw_case(seed, index, free_forms);
    const double vergence_D = vergence_of(run.numbers.distance_m);
    run.gaze = gaze_of(run.numbers);
    run.eye = eye_of(run.numbers);
    check_forms(run);
    check_correction(run.outcomes, prescription_of(run.numbers), run.eye ? &*run.eye : nullptr);
    if (!run.eye) return run;
    if (run.numbers.lens) {
      run.lens = spectacles_of(*run.numbers.lens, free_forms);
      if (const auto& made = run.numbers.lens->made)
        check_prism(run.outcomes, *run.lens, made->prism_cm_per_m, made->prism_base_deg);
      run_through_lens(run, seed, index, vergence_D, tracer);
    } else {
      run_naked(run, vergence_D);
    }
    if (run.footprint) check_other_methods(run, vergence_D);
  } catch (const std::exception& error) {
    run.thrown = error.what();
    run.outcomes.expect(Check::finite, false);
  }
  return run;
}

}  // namespace sturm::stress
