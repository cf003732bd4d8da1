#pragma once
#include <nlohmann/json.hpp>

/// A report in which everything is as it should be, with numbers made by hand; tests spoil one thing at a time.
namespace sturm::testing {

inline nlohmann::json rays(const char* model, double z, double relative, nlohmann::json closed_form = nullptr) {
  return {{"ray_model", model},
          {"status", "ok"},
          {"against_conoid", {{"z_max", z}, {"relative_frobenius", relative}}},
          {"against_closed_form", closed_form}};
}

/// V = diag(2, 1) D and a = 2 mm in units of a²/4: wavefront diag(4, 1), sin² diag(25/8, 13/8).
inline nlohmann::json ellipse_case(const char* id, double cylinder_D) {
  const bool round = cylinder_D == 0.0;
  const nlohmann::json conoid = round ? nlohmann::json{4.0, 0.0, 4.0} : nlohmann::json{4.0, 0.0, 1.0};
  const nlohmann::json sin2 = round ? nlohmann::json{4.0, 0.0, 4.0} : nlohmann::json{3.125, 0.0, 1.625};
  const double sin2_difference = round ? 1e-6 : 0.26079;  // √(0.875² + 0.625²)/√17 = 0.260798
  return {{"id", id},
          {"cylinder_D", cylinder_D},
          {"conoid", {{"covariance_rad2", conoid}}},
          {"sin2_closed_form", {{"covariance_rad2", sin2}}},
          {"rays",
           {rays("power_matrix", 1.5, 2e-6),
            rays("sin2_radial", round ? 1.2 : 90000.0, sin2_difference, {{"z_max", 2.0}, {"relative_frobenius", 3e-6}}),
            rays("thin_lens", round ? 0.9 : 5e4, round ? 1e-6 : 0.5)}}};
}

inline nlohmann::json psf(const char* id) {
  return {{"id", id},
          {"ray_model", "power_matrix"},
          {"pixel_arcmin", 0.5},
          {"predicted", {{"semi_axes_arcmin", {12.0, 6.0}}, {"orientation_deg", 30.0}}},
          {"measured",
           {{"semi_axes_arcmin", {12.03, 5.98}},
            {"orientation_deg", 30.1},
            {"standard_error_arcmin", {0.02, 0.01}},
            {"centroid_arcmin", {0.02, -0.03}},
            {"centroid_standard_error_arcmin", {0.02, 0.02}}}}};
}

inline nlohmann::json image(const char* id, const char* model, double ssim, double rmse) {
  return {{"id", id},
          {"ray_model", model},
          {"metrics",
           {{"ssim_display", {{"value", ssim}, {"uncertainty", 0.004}}},
            {"light_ratio", {{"value", 0.9995}, {"uncertainty", 0.0004}}},
            {"shift_x_px", {{"value", -0.03}, {"uncertainty", 0.01}}},
            {"shift_y_px", {{"value", 0.04}, {"uncertainty", 0.01}}},
            {"rmse_linear", rmse}}},
          {"noise_floor", {{"ssim_display", 0.975}, {"rmse_linear", 0.02}}}};
}

inline nlohmann::json mutant(const char* id, double value, double bound) {
  return {{"id", id}, {"failed_as_it_must", true}, {"value", value}, {"bound", bound}};
}

inline nlohmann::json healthy_report() {
  nlohmann::json report;
  report["reference"] = {
      {"cases", 150},
      {"max_relative_error", {{"conoid_semi_axes", 3e-16}, {"conoid_covariance", 5e-16}, {"sin2_closed_form", 4e-16}}}};
  report["ellipses"]["cases"] = {ellipse_case("A|1 m|4 mm", -1.0), ellipse_case("A|inf|4 mm", -1.0),
                                 ellipse_case("B|1 m|4 mm", 0.0)};
  report["psfs"] = nlohmann::json::array({psf("spot")});
  report["images"] = {image("cornell", "power_matrix", 0.97, 0.011), image("cornell", "sin2_radial", 0.93, 0.04),
                      image("chart", "power_matrix", 0.98, 0.012)};
  report["must_fail"] = {mutant("mirrored_axis", 2.0, 0.005), mutant("double_pupil", 0.05, 0.005)};
  report["gate_power"]["mutations"] = {{{"id", "half_pixel"}, {"caught_by", {{{"gate", "image_is_in_its_place"}}}}}};
  return report;
}

}  // namespace sturm::testing
