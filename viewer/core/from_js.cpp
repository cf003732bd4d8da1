#include "viewer/core/from_js.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "lensmodel/needed_power.h"
#include "lensmodel/progressive.h"
#include "lensmodel/single_vision.h"
#include "pathtrace/cameras/camera_pose.h"

namespace sturm::viewer {

using emscripten::val;

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument(what);
}

double number(const val& object, const char* key) {
  const val member = object[key];
  if (!member.isNumber()) refuse(std::string("no number \"") + key + "\"");
  return member.as<double>();
}

double positive(const val& object, const char* key) {
  const double value = number(object, key);
  if (!(value > 0.0 && std::isfinite(value)))
    refuse(std::string(key) + " is " + std::to_string(value) + ", expected more than 0");
  return value;
}

int count(const val& object, const char* key, int least, int most) {
  const double value = number(object, key);
  if (!(value >= least && value <= most && value == std::floor(value)))
    refuse(std::string(key) + " is " + std::to_string(value) + ", expected a whole number from " +
           std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(value);
}

std::string word(const val& object, const char* key) {
  const val member = object[key];
  if (!member.isString()) refuse(std::string("no word \"") + key + "\"");
  return member.as<std::string>();
}

bool is_missing(const val& value) {
  return value.isNull() || value.isUndefined();
}

std::optional<double> number_or_none(const val& object, const char* key) {
  return is_missing(object[key]) ? std::nullopt : std::optional(number(object, key));
}

template <int n>
Eigen::Matrix<double, n, 1> vector(const val& object, const char* key) {
  const val list = object[key];
  Eigen::Matrix<double, n, 1> v;
  for (int k = 0; k < n; ++k) {
    const val entry = is_missing(list) ? val::undefined() : list[k];
    if (!entry.isNumber()) refuse(std::string("no list of numbers \"") + key + "\"");
    v[k] = entry.template as<double>();
  }
  return v;
}

Prescription read_prescription(const val& rx) {
  Prescription result;
  result.sphere_D = number(rx, "sphere_D");
  result.cylinder_D = number(rx, "cylinder_D");
  result.axis_deg = number(rx, "axis_deg");
  result.vertex_distance_m = number(rx, "vertex_distance_m");
  result.prism_cm_per_m = number(rx, "prism_cm_per_m");
  result.prism_base_deg = number(rx, "prism_base_deg");
  return result;
}

Accommodation read_accommodation(const val& value) {
  const std::string mode = word(value, "mode");
  if (mode == "relaxed") return RelaxedAccommodation{};
  if (mode == "best") {
    const double amplitude = number(value, "amplitude_D");
    if (!(amplitude >= 0.0 && amplitude <= 100.0))
      refuse("amplitude_D is " + std::to_string(amplitude) + ", expected 0 to 100");
    return BestAccommodation{amplitude};
  }
  if (mode != "fixed") refuse("accommodation mode \"" + mode + "\", expected relaxed, fixed or best");
  if (const auto power = number_or_none(value, "power_D")) {
    if (!(*power >= 0.0 && *power <= 1000.0)) refuse("power_D is " + std::to_string(*power) + ", expected 0 to 1000");
    return FixedAccommodation{*power, 0.0};
  }
  const val stated = value["focus_distance_m"];
  const bool far = stated.isString() && stated.as<std::string>() == "inf";
  const double distance = far ? std::numeric_limits<double>::infinity() : number(value, "focus_distance_m");
  if (!(distance >= 1e-3)) refuse("focus_distance_m is " + std::to_string(distance) + ", expected 0.001 or more");
  return FixedAccommodation{1.0 / distance, distance};
}

ZernikeWave read_wavefront(const val& value) {
  const auto coefficients = emscripten::convertJSArrayToNumberVector<double>(value["coefficients_m"]);
  return ZernikeWave::from_examiner(coefficients, positive(value, "radius_m"));
}

SecondOrder read_second_order(const val& value) {
  const auto rule = second_order_words.value_of(word(value, "second_order"));
  if (!rule) refuse("second_order is neither least_squares nor paraxial");
  return *rule;
}

Mounting read_mounting(const val& value) {
  return {vector<2>(value, "decentration_m"), number(value, "pantoscopic_tilt_rad"), number(value, "wrap_rad")};
}

SingleVisionDesign read_design(const val& lens) {
  SingleVisionDesign design;
  design.base_curve_D = number_or_none(lens, "base_curve_D");
  design.center_thickness_m = positive(lens, "center_thickness_m");
  design.refractive_index = positive(lens, "refractive_index");
  design.vertex_distance_m = number(lens, "vertex_distance_m");
  design.diameter_m = positive(lens, "diameter_m");
  design.mounting = read_mounting(lens["mounting"]);
  return design;
}

BSplineSurface read_spline(const val& surface) {
  KnotGrid grid;
  grid.first = vector<2>(surface, "first_m");
  grid.spacing = vector<2>(surface, "spacing_m");
  const Eigen::Vector2d cells = vector<2>(surface, "cells");
  if (!(cells.minCoeff() >= 3.0 && cells.maxCoeff() <= 4096.0) || !(grid.spacing.minCoeff() > 0.0))
    refuse("a spline needs 3 to 4096 cells each way");
  grid.cells_x = static_cast<int>(cells.x());
  grid.cells_y = static_cast<int>(cells.y());
  const auto numbers = emscripten::convertJSArrayToNumberVector<double>(surface["coefficients_m"]);
  const int rows = grid.cells_x + 3, columns = grid.cells_y + 3;
  if (numbers.size() != static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns))
    refuse("a spline has (cells_x + 3) x (cells_y + 3) coefficients");
  return BSplineSurface(grid, Eigen::Map<const BSplineSurface::Coefficients>(numbers.data(), rows, columns));
}

Spectacles read_made(const std::string& kind, const val& lens, const Eye& eye) {
  const SingleVisionDesign design = read_design(lens);
  const Prescription rx = is_missing(lens["prescription"]) ? needed_power(eye, design.vertex_distance_m)
                                                           : read_prescription(lens["prescription"]);
  if (kind == "single_vision") return single_vision(rx, design);
  if (!is_missing(lens["front"])) {  // as `progressive_lens` puts it together
    Spectacles made = single_vision(rx, design);
    made.front = read_spline(lens["front"]);
    return made;
  }
  ProgressiveDesign progressive;
  progressive.lens = design;
  progressive.addition_D = number(lens, "addition_D");
  progressive.corridor_start_m = number(lens, "corridor_start_m");
  progressive.corridor_length_m = positive(lens, "corridor_length_m");
  progressive.near_shift_m = number(lens, "near_shift_m");
  progressive.zone_width_m = number_or_none(lens, "zone_width_m");
  progressive.knot_spacing_m = positive(lens, "knot_spacing_m");
  return progressive_lens(rx, progressive).lens;
}

Surface read_surface(const val& surface) {
  const std::string type = word(surface, "type");
  if (type == "sphere") return SphereSurface{number(surface, "curvature_per_m")};
  if (type == "conic") return ConicSurface{number(surface, "curvature_per_m"), number(surface, "conic_constant")};
  if (type == "torus")
    return TorusSurface(number(surface, "sweep_curvature_per_m"), number(surface, "generator_curvature_per_m"),
                        number(surface, "sweep_meridian_deg"));
  if (type == "spline") return read_spline(surface);
  refuse("surface type \"" + type + "\", expected sphere, conic, torus or spline");
}

Spectacles read_two_surfaces(const val& lens) {
  const SingleVisionDesign design = read_design(lens);
  Spectacles result;
  result.front = read_surface(lens["front"]);
  result.back = read_surface(lens["back"]);
  result.center_thickness_m = design.center_thickness_m;
  result.refractive_index = design.refractive_index;
  result.vertex_distance_m = design.vertex_distance_m;
  result.diameter_m = design.diameter_m;
  const Eigen::Vector2d wedge = vector<2>(lens, "wedge");
  result.mounting = wedge.isZero(0.0) ? design.mounting : design.mounting.with_wedge(wedge);
  return result;
}

}  // namespace

Eye read_eye(const val& numbers) {
  const double pupil = number(numbers, "pupil_diameter_m");
  const Accommodation accommodation = read_accommodation(numbers["accommodation"]);
  const val rx = numbers["prescription"], wave = numbers["wavefront"];
  std::optional<Prescription> prescription;
  if (!is_missing(rx)) prescription = read_prescription(rx);
  if (!prescription && is_missing(wave)) refuse("an eye has a prescription or a wavefront");
  Eye eye = is_missing(wave)
                ? Eye::with(*prescription, pupil, accommodation)
                : Eye::with(read_wavefront(wave), read_second_order(wave), prescription, pupil, accommodation);
  eye.rotation_center_m = number(numbers, "rotation_center_m");
  if (!(eye.rotation_center_m >= 0.0 && eye.rotation_center_m <= 0.1))
    refuse("rotation_center_m is " + std::to_string(eye.rotation_center_m) + ", expected 0 to 0.1");
  return eye;
}

std::optional<Spectacles> read_lens(const val& numbers, const Eye& eye) {
  if (is_missing(numbers)) return std::nullopt;
  const std::string kind = word(numbers, "kind");
  if (kind == "surfaces") return read_two_surfaces(numbers);
  if (kind == "single_vision" || kind == "progressive") return read_made(kind, numbers, eye);
  refuse("lens kind \"" + kind + "\", expected single_vision, progressive or surfaces");
}

FieldGrid read_grid(const val& numbers) {
  FieldGrid grid;
  grid.nx = count(numbers, "nx", 2, 1024);
  grid.ny = count(numbers, "ny", 2, 1024);
  grid.nz = count(numbers, "nz", 2, 1024);
  grid.tan_half_width = positive(numbers, "tan_half_width");
  grid.tan_half_height = positive(numbers, "tan_half_height");
  grid.near_vergence_D = positive(numbers, "near_vergence_D");
  grid.far_vergence_D = number(numbers, "far_vergence_D");
  if (!(grid.far_vergence_D >= 0.0 && grid.far_vergence_D < grid.near_vergence_D))
    refuse("far_vergence_D must lie from 0 to below near_vergence_D");
  return grid;
}

Gaze read_gaze(const val& word) {
  const auto gaze = word.isString() ? gaze_words.value_of(word.as<std::string>()) : std::nullopt;
  if (!gaze) refuse("gaze is neither camera nor foveal");
  return *gaze;
}

PicturePlane read_camera(const val& numbers) {
  CameraPose pose;
  pose.position = vector<3>(numbers, "position_m");
  pose.look_at = vector<3>(numbers, "look_at_m");
  pose.up = vector<3>(numbers, "up");
  pose.vertical_field = positive(numbers, "vfov_rad");
  pose.width = count(numbers, "width", 1, 16384);
  pose.height = count(numbers, "height", 1, 16384);
  return {pose.position, head_axes(pose), pose.width, pose.height, pixel_slope(pose), read_gaze(numbers["gaze"])};
}

}  // namespace sturm::viewer
