#include "stages/page/optics_numbers.h"

#include <nlohmann/json.hpp>

#include "io/json/values.h"
#include "lensmodel/units.h"
#include "lensmodel/zernike_order.h"

namespace sturm {

namespace {

template <class Vector>
Json list(const Vector& v) {
  Json numbers = Json::array();
  for (Eigen::Index k = 0; k < v.size(); ++k) numbers.push_back(v.data()[k]);
  return numbers;
}

struct AccommodationJson {
  Json operator()(const RelaxedAccommodation&) const { return {{"mode", "relaxed"}}; }
  Json operator()(const FixedAccommodation& fixed) const {
    if (fixed.focus_distance_m == 0.0) return {{"mode", "fixed"}, {"power_D", fixed.power_D}};
    return {{"mode", "fixed"}, {"focus_distance_m", distance_json(fixed.focus_distance_m)}};
  }
  Json operator()(const BestAccommodation& best) const { return {{"mode", "best"}, {"amplitude_D", best.amplitude_D}}; }
};

/// The eye does not keep by which rule its power was taken from the wavefront: it is the one that gives this power.
SecondOrder rule_of(const Eye& eye) {
  const Eye nearest = Eye::with(*eye.wavefront, SecondOrder::LeastSquares, std::nullopt, 2.0 * eye.pupil_radius_m);
  return nearest.correction.matrix() == eye.correction.matrix() ? SecondOrder::LeastSquares : SecondOrder::Paraxial;
}

Json prescription_numbers(const Prescription& rx) {
  return {{"sphere_D", rx.sphere_D},
          {"cylinder_D", rx.cylinder_D},
          {"axis_deg", rx.axis_deg},
          {"vertex_distance_m", rx.vertex_distance_m},
          {"prism_cm_per_m", rx.prism_cm_per_m},
          {"prism_base_deg", rx.prism_base_deg}};
}

Json mounting_numbers(const Mounting& mounting) {
  return {{"decentration_m", list(mounting.decentration_m())},
          {"pantoscopic_tilt_rad", mounting.pantoscopic_tilt()},
          {"wrap_rad", mounting.wrap()}};
}

struct SurfaceNumbers {
  Json operator()(const SphereSurface& s) const { return {{"type", "sphere"}, {"curvature_per_m", s.curvature}}; }
  Json operator()(const ConicSurface& s) const {
    return {{"type", "conic"}, {"curvature_per_m", s.curvature}, {"conic_constant", s.conic_constant}};
  }
  Json operator()(const TorusSurface& s) const {
    const Eigen::Vector2d& along = s.sweep_direction();
    // The examiner's x is the wearer's −x.
    const double meridian_deg = folded_axis_deg(180.0 - line_direction_deg(std::atan2(along.y(), along.x())));
    return {{"type", "torus"},
            {"sweep_curvature_per_m", s.sweep_curvature()},
            {"generator_curvature_per_m", s.generator_curvature()},
            {"sweep_meridian_deg", meridian_deg}};
  }
  Json operator()(const BSplineSurface& s) const {
    const KnotGrid& grid = s.grid();
    return {{"type", "spline"},
            {"first_m", list(grid.first)},
            {"spacing_m", list(grid.spacing)},
            {"cells", {grid.cells_x, grid.cells_y}},
            {"coefficients_m", list(s.coefficients())}};
  }
};

}  // namespace

Json eye_numbers(const Eye& eye) {
  Json numbers = {{"prescription", nullptr},
                  {"wavefront", nullptr},
                  {"pupil_diameter_m", 2.0 * eye.pupil_radius_m},
                  {"rotation_center_m", eye.rotation_center_m},
                  {"accommodation", std::visit(AccommodationJson{}, eye.accommodation)}};
  if (!eye.wavefront) {
    numbers["prescription"] = prescription_numbers(eye.prescription);
    return numbers;
  }
  numbers["wavefront"] = {{"coefficients_m", mirrored(eye.wavefront->coefficients())},
                          {"radius_m", eye.wavefront->radius_m()},
                          {"second_order", second_order_words.word_of(rule_of(eye))}};
  return numbers;
}

Json lens_numbers(const Spectacles& lens) {
  return {{"kind", "surfaces"},
          {"front", std::visit(SurfaceNumbers{}, lens.front)},
          {"back", std::visit(SurfaceNumbers{}, lens.back)},
          {"wedge", list(lens.mounting.wedge())},
          {"center_thickness_m", lens.center_thickness_m},
          {"refractive_index", lens.refractive_index},
          {"vertex_distance_m", lens.vertex_distance_m},
          {"diameter_m", lens.diameter_m},
          {"mounting", mounting_numbers(lens.mounting)}};
}

Json lens_numbers(const LensDesign& design) {
  Json numbers = {{"kind", design.progressive ? "progressive" : "single_vision"},
                  {"prescription", prescription_numbers(design.power)},
                  {"base_curve_D", number_or_null(design.lens.base_curve_D)},
                  {"center_thickness_m", design.lens.center_thickness_m},
                  {"refractive_index", design.lens.refractive_index},
                  {"vertex_distance_m", design.lens.vertex_distance_m},
                  {"diameter_m", design.lens.diameter_m},
                  {"mounting", mounting_numbers(design.lens.mounting)}};
  if (!design.progressive) return numbers;
  numbers["addition_D"] = design.progressive->addition_D;
  numbers["corridor_start_m"] = design.progressive->corridor_start_m;
  numbers["corridor_length_m"] = design.progressive->corridor_length_m;
  numbers["near_shift_m"] = design.progressive->near_shift_m;
  numbers["zone_width_m"] = number_or_null(design.progressive->zone_width_m);
  numbers["knot_spacing_m"] = design.progressive->knot_spacing_m;
  return numbers;
}

}  // namespace sturm
