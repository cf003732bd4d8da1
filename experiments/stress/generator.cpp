#include "experiments/stress/generator.h"

#include <algorithm>
#include <cmath>

#include "conoid/tracing/spectacle_conoid.h"
#include "experiments/stress/random.h"
#include "lensmodel/gaze.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm::stress {

namespace {

Family drawn_family(Random& random) {
  double at = random.unit();
  for (const FamilyInfo& f : families)
    if ((at -= f.share) < 0.0) return f.family;
  return Family::ordinary;
}

double drawn_distance(Random& random) {
  return random.chance(0.2) ? std::numeric_limits<double>::infinity() : random.log_uniform(0.1, 100.0);
}

/// Half of the prescriptions as they are written, in steps; half anything.
void draw_prescription(Random& random, CaseNumbers& n) {
  const bool written = random.chance(0.5);
  n.sphere_D = written ? random.stepped(-25.0, 25.0, 0.25) : random.uniform(-25.0, 25.0);
  n.cylinder_D = written ? random.stepped(-12.0, 12.0, 0.25) : random.uniform(-12.0, 12.0);
  n.axis_deg = written ? random.stepped(0.0, 180.0, 1.0) : random.uniform(0.0, 180.0);
  n.rx_vertex_distance_mm = random.chance(0.3) ? 0.0 : random.uniform(8.0, 18.0);
}

void draw_accommodation(Random& random, CaseNumbers& n) {
  constexpr std::array modes{CaseNumbers::Mode::relaxed, CaseNumbers::Mode::fixed, CaseNumbers::Mode::best};
  n.mode = modes[static_cast<std::size_t>(random.below(3))];
  n.accommodation_D = n.mode == CaseNumbers::Mode::relaxed ? 0.0 : random.uniform(0.0, 12.0);
}

/// A radius [mm] of a surface of this power; flat where it has none.
double radius_mm(double power_D, double index) {
  return power_D == 0.0 ? flat : std::clamp(1e3 * (index - 1.0) / power_D, -1e9, 1e9);
}

/// A lens like those that are made: a spherical or mildly conic front, a back that has the prescription within a few
/// dioptres.
LensNumbers real_lens(Random& random, const CaseNumbers& n) {
  constexpr std::array indices{1.498, 1.523, 1.586, 1.6, 1.67, 1.74};
  LensNumbers lens;
  lens.refractive_index = indices[static_cast<std::size_t>(random.below(6))];
  lens.center_thickness_mm = random.uniform(1.0, 8.0);
  lens.vertex_distance_mm = random.uniform(8.0, 18.0);
  lens.diameter_mm = random.uniform(40.0, 80.0);
  const double front = std::max(0.5, random.uniform(0.0, 8.0) + 0.5 * std::max(0.0, n.sphere_D));
  lens.front = {SurfaceNumbers::Kind::sphere, radius_mm(front, lens.refractive_index), flat, 0.0, 0.0};
  if (random.chance(0.3)) {
    lens.front.kind = SurfaceNumbers::Kind::conic;
    lens.front.conic_constant = random.uniform(-3.0, 1.0);
  }
  lens.back = {SurfaceNumbers::Kind::torus, radius_mm(front - n.sphere_D, lens.refractive_index),
               radius_mm(front - n.sphere_D - n.cylinder_D, lens.refractive_index), n.axis_deg, 0.0};
  if (random.chance(0.1)) lens.back = {SurfaceNumbers::Kind::sphere, lens.back.radius_mm, flat, 0.0, 0.0};
  return lens;
}

void draw_gaze(Random& random, CaseNumbers& n, double most_deg) {
  if (random.chance(0.05)) return;
  n.azimuth_deg = random.uniform(-most_deg, most_deg);
  n.elevation_deg = random.uniform(-most_deg, most_deg);
}

/// As frames hold lenses, or as far as documents allow; some angles and shifts exactly 0.
MountingNumbers drawn_mounting(Random& random, bool extreme) {
  const auto up_to = [&](double usual, double most) {
    return random.chance(0.2) ? 0.0 : random.uniform(-1.0, 1.0) * (extreme ? most : usual);
  };
  MountingNumbers m;
  m.right_mm = up_to(5.0, 20.0);
  m.up_mm = up_to(5.0, 20.0);
  m.pantoscopic_tilt_deg = up_to(20.0, 45.0);
  m.wrap_deg = up_to(25.0, 45.0);
  return m;
}

/// The lens becomes a single-vision lens for the prescription, with a prism.
void make_prism(Random& random, CaseNumbers& n, double most_cm_per_m) {
  const double base_curve = std::max(0.5, random.uniform(0.0, 8.0) + 0.5 * std::max(0.0, n.sphere_D));
  SingleVisionNumbers made{n.sphere_D, n.cylinder_D, n.axis_deg, base_curve, 0.0, 0.0};
  made.prism_cm_per_m =
      random.chance(0.5) ? random.stepped(0.25, most_cm_per_m, 0.25) : random.uniform(0.0, most_cm_per_m);
  if (random.chance(0.1)) made.prism_cm_per_m = random.log_uniform(1e-17, 1e-3);
  made.prism_base_deg = random.chance(0.5) ? random.stepped(0.0, 360.0, 45.0) : random.uniform(0.0, 360.0);
  n.lens->made = made;
}

void draw_ordinary(Random& random, CaseNumbers& n) {
  draw_prescription(random, n);
  draw_accommodation(random, n);
  n.pupil_diameter_mm = random.uniform(1.0, 8.0);
  n.rotation_center_mm = random.uniform(11.0, 16.0);
  n.lens = real_lens(random, n);
  if (random.chance(0.2)) n.lens->mounting = drawn_mounting(random, false);
  if (n.family == Family::ordinary && random.chance(0.1)) make_prism(random, n, 10.0);
  draw_gaze(random, n, 35.0);
  n.distance_m = drawn_distance(random);
}

/// The lens's back becomes a sphere about the eye's centre of rotation, off by the part `off` of its radius: every gaze
/// meets it at right angles. That takes a lens that stands straight.
void make_concentric(CaseNumbers& n, double off) {
  n.lens->mounting = {};
  n.lens->back = {SurfaceNumbers::Kind::sphere, (n.rotation_center_mm + n.lens->vertex_distance_mm) * (1.0 + off), flat,
                  0.0, 0.0};
}

/// Sets the distance at which X = A + dB loses its rank, where there is one ahead.
void aim_at_focal_line(CaseNumbers& n, const FreeFormLenses& free_forms) {
  n.mode = CaseNumbers::Mode::relaxed;
  const auto eye = eye_of(n);
  if (!eye) return;
  const SpectacleConoid conoid = trace_conoid(spectacles_of(*n.lens, free_forms), gaze_of(n), eye->rotation_center_m);
  if (conoid.status != LensStatus::ok) return;
  const auto k = conoid.exit_curvature(eye->slope_matrix(0.0).matrix());
  if (!k) return;
  const PrincipalValues p = principal_values((*k)(0, 0), (*k)(0, 1), (*k)(1, 1));
  for (const double kappa : {p.low, p.high})
    if (kappa > 1e-6 && kappa < 1e5) n.distance_m = 1.0 / kappa;
}

/// Accommodation that focuses the sphere `fraction` of the way through the glass: slopes S = −1/distance, the way to
/// the back at least.
void focus_near_lens(Random& random, CaseNumbers& n, bool on_surface, const FreeFormLenses& free_forms) {
  n.sphere_D = n.cylinder_D = 0.0;
  if (random.chance(0.5)) n.cylinder_D = random.uniform(-4.0, 4.0);
  n.mode = CaseNumbers::Mode::fixed;
  const LensPath path =
      trace(spectacles_of(*n.lens, free_forms),
            {turned_pupil_center(gaze_of(n), metres_per_millimetre * n.rotation_center_mm), gaze_of(n)});
  const double to_back =
      path.status == LensStatus::ok
          ? (path.back_point - turned_pupil_center(gaze_of(n), metres_per_millimetre * n.rotation_center_mm)).norm()
          : metres_per_millimetre * n.lens->vertex_distance_mm;
  const double inside =
      on_surface ? 0.0 : random.unit() * metres_per_millimetre * n.lens->center_thickness_mm / n.lens->refractive_index;
  n.accommodation_D = 1.0 / (to_back + inside);
}

void make_strong(Random& random, SurfaceNumbers& s) {
  s.kind = random.chance(0.5) ? SurfaceNumbers::Kind::conic : SurfaceNumbers::Kind::torus;
  s.radius_mm = random.either_sign(random.log_uniform(8.0, 100.0));
  s.generator_radius_mm = random.either_sign(random.log_uniform(8.0, 100.0));
  s.sweep_meridian_deg = random.uniform(-360.0, 360.0);
  s.conic_constant = random.either_sign(random.log_uniform(0.1, 1000.0));
}

void make_adversarial(Random& random, CaseNumbers& n, const FreeFormLenses& free_forms) {
  LensNumbers& lens = *n.lens;
  switch (n.family) {
    case Family::ordinary:
      break;
    case Family::naked_eye:
      n.lens.reset();
      draw_gaze(random, n, 89.0);
      break;
    case Family::total_reflection:
      if (random.chance(0.5)) make_concentric(n, 0.0);
      lens.diameter_mm = 200.0;
      lens.refractive_index = random.uniform(1.4, 2.5);
      draw_gaze(random, n, 60.0);
      break;
    case Family::missed_rim:
      lens.diameter_mm = random.log_uniform(1e-3, 40.0);
      break;
    case Family::grazing:
      lens.diameter_mm = 200.0;
      draw_gaze(random, n, 89.0);
      if (random.chance(0.5))
        lens.back.radius_mm = lens.back.generator_radius_mm = random.either_sign(random.log_uniform(10.0, 1e3));
      break;
    case Family::plano:
      if (random.chance(0.6))
        lens.back = {random.chance(0.5) ? SurfaceNumbers::Kind::torus : SurfaceNumbers::Kind::sphere, flat, flat, 30.0,
                     0.0};
      if (random.chance(0.5)) lens.back = {SurfaceNumbers::Kind::torus, lens.back.radius_mm, flat, n.axis_deg, 0.0};
      if (random.chance(0.6))
        lens.front = {random.chance(0.5) ? SurfaceNumbers::Kind::conic : SurfaceNumbers::Kind::sphere, flat, flat, 0.0,
                      -1.0};
      break;
    case Family::concentric:
      make_concentric(n, 0.0);
      break;
    case Family::nearly_concentric:
      make_concentric(n, random.either_sign(random.log_uniform(1e-16, 1e-3)));
      break;
    case Family::power_through_zero:
      n.sphere_D = random.chance(0.5) ? 0.0 : random.either_sign(random.log_uniform(1e-18, 1e-3));
      if (random.chance(0.5)) n.cylinder_D = -n.sphere_D;
      break;
    case Family::nearly_flat:
      lens.front = {SurfaceNumbers::Kind::sphere, random.either_sign(random.log_uniform(1e4, 1e9)), flat, 0.0, 0.0};
      lens.back.radius_mm = random.either_sign(random.log_uniform(1e4, 1e9));
      lens.back.generator_radius_mm = random.either_sign(random.log_uniform(1e2, 1e9));
      break;
    case Family::focus_in_glass:
      focus_near_lens(random, n, false, free_forms);
      break;
    case Family::focus_on_surface:
      focus_near_lens(random, n, true, free_forms);
      break;
    case Family::focus_on_target:
      aim_at_focal_line(n, free_forms);
      break;
    case Family::equal_eigenvalues:
      n.cylinder_D = random.chance(0.5) ? 0.0 : random.either_sign(random.log_uniform(1e-17, 1e-9));
      lens.back.generator_radius_mm = lens.back.radius_mm;
      lens.mounting = {};
      n.azimuth_deg = n.elevation_deg = 0.0;
      break;
    case Family::no_cylinder:
      n.cylinder_D = 0.0;
      break;
    case Family::axis_0_and_180:
      n.axis_deg = lens.back.sweep_meridian_deg = random.chance(0.5) ? 0.0 : 180.0;
      break;
    case Family::vertex_at_focus:
      n.rx_vertex_distance_mm = random.uniform(25.0, 50.0);
      n.sphere_D = 1e3 / n.rx_vertex_distance_mm *
                   (random.chance(0.4) ? 1.0 : 1.0 + random.either_sign(random.log_uniform(1e-16, 1e-3)));
      n.sphere_D = std::min(n.sphere_D, 40.0);
      if (random.chance(0.3)) n.cylinder_D = 0.0;
      break;
    case Family::extreme_distance:
      n.distance_m = random.chance(0.5) ? random.log_uniform(1e-6, 1e-2) : random.log_uniform(1e3, 1e12);
      break;
    case Family::no_pupil:
      n.pupil_diameter_mm = 0.0;
      break;
    case Family::index_one:
      lens.refractive_index = random.chance(0.5) ? 1.0 : 1.0 + random.log_uniform(1e-16, 1e-3);
      break;
    case Family::strong_surface:
      make_strong(random, random.chance(0.5) ? lens.back : lens.front);
      if (random.chance(0.3)) make_strong(random, lens.back);
      break;
    case Family::surface_ends:
      lens.back = {random.chance(0.5) ? SurfaceNumbers::Kind::sphere : SurfaceNumbers::Kind::torus,
                   random.either_sign(random.uniform(4.0, 30.0)), random.either_sign(random.uniform(4.0, 30.0)),
                   random.uniform(0.0, 180.0), 0.0};
      lens.diameter_mm = random.uniform(60.0, 200.0);
      break;
    case Family::mounted:
      lens.mounting = drawn_mounting(random, true);
      if (random.chance(0.4)) make_prism(random, n, 20.0);
      if (random.chance(0.1)) lens.mounting.pantoscopic_tilt_deg = random.either_sign(random.log_uniform(1e-17, 1e-3));
      break;
    case Family::free_form:
      lens.free_form = random.below(FreeFormLenses::count);
      break;
  }
}

}  // namespace

CaseNumbers draw_case(std::uint64_t seed, std::uint64_t index, const FreeFormLenses& free_forms) {
  Random random(seed, index);
  CaseNumbers n;
  n.family = drawn_family(random);
  draw_ordinary(random, n);
  make_adversarial(random, n, free_forms);
  return n;
}

}  // namespace sturm::stress
