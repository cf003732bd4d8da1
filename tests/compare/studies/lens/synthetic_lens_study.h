#pragma once
#include <nlohmann/json.hpp>

/// A section "lens_study" with numbers made by hand: two lenses and a spline, straight ahead and 20° to the right, two
/// pupils.
namespace sturm::test {

inline nlohmann::json pupil_error(double relative, double defocus_D, double pupil_mm) {
  // half-width [arcmin] = defocus · radius
  const double arcmin = defocus_D * 0.5 * pupil_mm * 3.4377467707849396;
  return {{"relative_frobenius", relative},
          {"semi_axes_arcmin", {arcmin, -0.5 * arcmin}},
          {"half_width_arcmin", arcmin},
          {"defocus_D", defocus_D}};
}

/// Errors of ray transfer grow as the square of the pupil; those of the other methods stay.
inline nlohmann::json study_pupil(double pupil_mm, double published_D, double previous_D, bool published_exists) {
  return {{"pupil_mm", pupil_mm},
          {"rays_lost", 0},
          {"real_semi_axes_arcmin", {3.4 * pupil_mm, 1.7 * pupil_mm}},
          {"ray_transfer", pupil_error(1e-3 * pupil_mm * pupil_mm, 1e-3 * pupil_mm * pupil_mm, pupil_mm)},
          {"published", published_exists ? pupil_error(0.1, published_D, pupil_mm) : nlohmann::json(nullptr)},
          {"previous", pupil_error(0.3, previous_D, pupil_mm)}};
}

inline nlohmann::json study_view(const char* lens, double eccentricity_deg, double published_D,
                                 bool published_exists = true) {
  nlohmann::json view = {
      {"lens", lens},
      {"eccentricity_deg", eccentricity_deg},
      {"direction_deg", eccentricity_deg > 0.0 ? nlohmann::json(0.0) : nlohmann::json(nullptr)},
      {"distance_m", 0.5},
      {"blur_D", {2.0, 1.0}},
      {"order", 4.01},
      {"relative_order", 1.99},
      {"limit_relative", 1e-6},
      {"previous_unscaled_error", 2e-14},
      {"mutant_orders", {{"published_as_exact", 2.1}, {"mirrored_gaze", 2.2}}},
      {"first_order",
       {{"published", published_exists ? nlohmann::json{{"relative_frobenius", 0.1}, {"defocus_D", published_D}}
                                       : nlohmann::json(nullptr)},
        {"previous", {{"relative_frobenius", 0.3}, {"defocus_D", 0.4}}}}}};
  for (const double pupil : {1.0, 6.0})
    view["pupils"].push_back(study_pupil(pupil, published_D, 0.4, published_exists));
  return view;
}

inline nlohmann::json study_gaze(const char* lens, double eccentricity_deg, const char* principal,
                                 const char* incidence) {
  return {{"lens", lens},
          {"eccentricity_deg", eccentricity_deg},
          {"direction_deg", eccentricity_deg > 0.0 ? nlohmann::json(0.0) : nlohmann::json(nullptr)},
          {"gaze_deg", {eccentricity_deg, 0.0}},
          {"status", "ok"},
          {"eq11", {{"principal", principal}, {"incidence", incidence}}}};
}

inline nlohmann::json study_lens(const char* id, bool revolution, double cylinder_D) {
  return {{"id", id},
          {"note", "by hand"},
          {"lens_of_revolution", revolution},
          {"analytic_surfaces", true},
          {"sphere_D", -3.0},
          {"cylinder_D", cylinder_D},
          {"axis_deg", 30.0},
          {"vertex_distance_mm", 12.0}};
}

inline nlohmann::json synthetic_lens_study() {
  const auto ellipse = [](double major, double minor) {
    return nlohmann::json{{"semi_axes_arcmin", {major, minor}}, {"orientation_deg", 30.0}};
  };
  nlohmann::json section;
  section["conditions"] = {
      {"radial", 10}, {"azimuthal", 40}, {"order_pupils_mm", {0.5, 1.0}}, {"rotation_center_mm", 13.5}};
  section["lenses"] = {study_lens("toric", false, -2.0), study_lens("round", true, 0.0),
                       study_lens("free form", false, 0.0)};
  section["lenses"][2]["analytic_surfaces"] = false;
  section["gazes"] = {study_gaze("toric", 0.0, "free_axes", "free_axes"), study_gaze("toric", 20.0, "ok", "negative"),
                      study_gaze("round", 0.0, "ok", "ok"), study_gaze("round", 20.0, "ok", "ok"),
                      study_gaze("free form", 20.0, "ok", "ok")};
  section["views"] = {study_view("toric", 0.0, 0.0, false), study_view("toric", 20.0, 0.2),
                      study_view("round", 0.0, 1e-14), study_view("round", 20.0, 2e-14),
                      study_view("free form", 20.0, 0.01)};
  section["views"][4]["order"] = 3.0;
  section["views"][4]["relative_order"] = 1.1;
  section["field"] = {{"lens", "toric"}, {"distance_m", "inf"}, {"pupil_mm", 4.0}};
  for (const double azimuth : {0.0, 25.0, 50.0})
    section["field"]["points"].push_back({{"azimuth_deg", azimuth},
                                          {"status", "ok"},
                                          {"real_rays", ellipse(6.0, 3.0)},
                                          {"ray_transfer", ellipse(6.0, 3.0)},
                                          {"published", azimuth > 0.0 ? ellipse(6.5, 3.0) : nlohmann::json(nullptr)},
                                          {"previous", ellipse(5.0, 2.0)}});
  return section;
}

}  // namespace sturm::test
