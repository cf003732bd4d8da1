#include "viewer/core/optics.h"

#include <algorithm>
#include <cmath>

#include "conoid/tracing/clear_vision.h"
#include "conoid/tracing/turned_eye.h"
#include "lensmodel/ellipse.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"
#include "viewer/core/from_js.h"
#include "viewer/core/to_js.h"

namespace sturm::viewer {

using emscripten::val;

namespace {

/// Coefficient of x^i y^k at i·(degree + 1) + k.
val square_of(const PlanePolynomial& polynomial, int degree) {
  const auto side = static_cast<std::size_t>(degree) + 1;
  std::vector<float> square(side * side, 0.0f);
  for (int k = 0; k <= polynomial.degree(); ++k)
    for (int i = 0; i + k <= polynomial.degree(); ++i)
      square[static_cast<std::size_t>(i) * side + static_cast<std::size_t>(k)] =
          static_cast<float>(polynomial.at(i, k));
  return copy_of(square);
}

val semi_axes(const Ellipse& ellipse, double scale) {
  return list_of(scale * ellipse.semi_major, scale * ellipse.semi_minor);
}

val symmetric_of(const Eigen::Matrix2d& m) {
  return list_of(m(0, 0), m(0, 1), m(1, 1));
}

/// A line of the wearer frame as an examiner writes it.
val tabo_of(const std::optional<double>& orientation_deg) {
  return orientation_deg ? val(folded_axis_deg(-*orientation_deg)) : val::null();
}

}  // namespace

void Optics::set_eye(const val& numbers) {
  eye_ = read_eye(numbers);
}

void Optics::set_lens(const val& numbers) {
  lens_ = read_lens(numbers, eye_);
}

val Optics::correction() const {
  return symmetric_of(eye_.correction.matrix());
}

val Optics::front_spline() const {
  const auto* spline = lens_ ? std::get_if<BSplineSurface>(&lens_->front) : nullptr;
  if (!spline) return val::null();
  const KnotGrid& grid = spline->grid();
  const BSplineSurface::Coefficients& heights = spline->coefficients();
  val result = val::object();
  result.set("type", std::string("spline"));
  result.set("first_m", list_of(grid.first.x(), grid.first.y()));
  result.set("spacing_m", list_of(grid.spacing.x(), grid.spacing.y()));
  result.set("cells", list_of(grid.cells_x, grid.cells_y));
  result.set("coefficients_m",
             val::global("Float64Array")
                 .new_(val(emscripten::typed_memory_view(static_cast<std::size_t>(heights.size()), heights.data()))));
  return result;
}

val Optics::accommodation(double azimuth, double elevation, double vergence_D) const {
  const TurnedEye turned(eye_, lens(), gaze_direction(azimuth, elevation));
  return turned.status() == LensStatus::ok ? val(turned.accommodation(vergence_D)) : val::null();
}

val Optics::wavefront_slopes() const {
  const ZernikeWave wave =  // as EyeRays has it
      eye_.wavefront.value_or(ZernikeWave::of_power(eye_.correction, std::max(eye_.pupil_radius_m, 1e-3)));
  const int degree = std::max(wave.slope_x().degree(), wave.slope_y().degree());
  val result = val::object();
  result.set("radius_m", wave.radius_m());
  result.set("degree", degree);
  result.set("x", square_of(wave.slope_x(), degree));
  result.set("y", square_of(wave.slope_y(), degree));
  return result;
}

val Optics::ellipse(double azimuth, double elevation, double distance_m) const {
  const TurnedEye turned(eye_, lens(), gaze_direction(azimuth, elevation));
  val result = val::object();
  result.set("status", name_of(turned.status()));
  if (turned.status() != LensStatus::ok) {
    for (const char* key :
         {"accommodation_D", "semi_axes_m", "semi_axes_rad", "semi_axes_arcmin", "semi_axes_D", "orientation_deg",
          "orientation_tabo_deg", "angular_footprint", "footprint", "wavefront_curvature_D", "chief_ray"})
      result.set(key, val::null());
    return result;
  }
  const Footprint f = turned.footprint(distance_m);
  const Ellipse angular = Ellipse::image_of_disc(f.angular, eye_.pupil_radius_m);
  const bool finite = std::isfinite(distance_m);
  result.set("accommodation_D", f.accommodation_D);
  result.set("semi_axes_m", finite ? semi_axes(angular, distance_m) : val::null());
  result.set("semi_axes_rad", semi_axes(angular, 1.0));
  result.set("semi_axes_arcmin", semi_axes(angular, arcminutes_per_radian));
  result.set("semi_axes_D", semi_axes(Ellipse::image_of_disc(f.angular, 1.0), 1.0));
  result.set("orientation_deg", number_or_null(angular.orientation_deg));
  result.set("orientation_tabo_deg", tabo_of(angular.orientation_deg));
  result.set("angular_footprint", rows_of(f.angular));
  result.set("footprint", finite ? rows_of(f.transverse()) : val::null());
  result.set("wavefront_curvature_D", f.wavefront_curvature ? symmetric_of(*f.wavefront_curvature) : val::null());
  val chief = val::object();
  chief.set("origin_m", list_of(turned.chief_ray().origin));
  chief.set("direction", list_of(turned.chief_ray().direction));
  result.set("chief_ray", chief);
  return result;
}

val Optics::errors(const val& gazes_rad, double distance_m) const {
  const auto gazes = emscripten::convertJSArrayToNumberVector<double>(gazes_rad);
  std::vector<float> numbers;
  numbers.reserve(2 * gazes.size());
  for (std::size_t k = 0; k + 1 < gazes.size(); k += 2) {
    const TurnedEye turned(eye_, lens(), gaze_direction(gazes[k], gazes[k + 1]));
    if (turned.status() != LensStatus::ok) {
      numbers.insert(numbers.end(), 4, 0.0f);
      continue;
    }
    const Ellipse error = Ellipse::image_of_disc(turned.footprint(distance_m).angular, 1.0);
    const Eigen::Vector3d& exit = turned.chief_ray().origin;
    for (const double x : {exit.x(), exit.y(), error.semi_major, 1.0}) numbers.push_back(static_cast<float>(x));
  }
  return copy_of(numbers);
}

val Optics::clear_vision(double azimuth, double elevation, double limit_rad) const {
  const TurnedEye turned(eye_, lens(), gaze_direction(azimuth, elevation));
  val result = val::object();
  result.set("status", name_of(turned.status()));
  for (const char* key : {"near_vergence_D", "far_vergence_D", "best_vergence_D", "best_semi_major_rad"})
    result.set(key, val::null());
  if (turned.status() != LensStatus::ok) return result;
  const ClearVision clear = sturm::clear_vision(turned, eye_.pupil_radius_m, limit_rad);
  result.set("best_vergence_D", clear.best_vergence_D);
  result.set("best_semi_major_rad", clear.best_semi_major_rad);
  if (!clear.interval) {
    result.set("status", std::string("never_clear"));
    return result;
  }
  result.set("near_vergence_D", clear.interval->near_vergence_D);
  result.set("far_vergence_D", clear.interval->far_vergence_D);
  return result;
}

}  // namespace sturm::viewer
