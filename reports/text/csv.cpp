#include "reports/text/csv.h"

#include <string_view>

#include "compare/studies/lens/lens_study_errors.h"
#include "io/files/csv.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

struct CsvColumn {
  std::string_view heading, path;
};

constexpr CsvColumn case_columns[] = {{"case", "id"},
                                      {"prescription", "prescription"},
                                      {"sphere_D", "sphere_D"},
                                      {"cylinder_D", "cylinder_D"},
                                      {"axis_deg", "axis_deg"},
                                      {"vertex_distance_mm", "vertex_distance_mm"},
                                      {"distance_m", "distance_m"},
                                      {"pupil_mm", "pupil_mm"},
                                      {"accommodation_D", "accommodation_D"},
                                      {"conoid_semi_major_rad", "conoid/semi_axes_rad/0"},
                                      {"conoid_semi_minor_rad", "conoid/semi_axes_rad/1"},
                                      {"conoid_orientation_deg", "conoid/orientation_deg"},
                                      {"conoid_covariance_xx_rad2", "conoid/covariance_rad2/0"},
                                      {"conoid_covariance_xy_rad2", "conoid/covariance_rad2/1"},
                                      {"conoid_covariance_yy_rad2", "conoid/covariance_rad2/2"},
                                      {"sin2_closed_form_covariance_xx_rad2", "sin2_closed_form/covariance_rad2/0"},
                                      {"sin2_closed_form_covariance_xy_rad2", "sin2_closed_form/covariance_rad2/1"},
                                      {"sin2_closed_form_covariance_yy_rad2", "sin2_closed_form/covariance_rad2/2"}};

constexpr CsvColumn ray_columns[] = {{"ray_model", "ray_model"},
                                     {"status", "status"},
                                     {"semi_major_rad", "semi_axes_rad/0"},
                                     {"semi_minor_rad", "semi_axes_rad/1"},
                                     {"orientation_deg", "orientation_deg"},
                                     {"covariance_xx_rad2", "covariance_rad2/0"},
                                     {"covariance_xy_rad2", "covariance_rad2/1"},
                                     {"covariance_yy_rad2", "covariance_rad2/2"},
                                     {"covariance_xx_standard_error_rad2", "covariance_standard_error_rad2/0"},
                                     {"covariance_xy_standard_error_rad2", "covariance_standard_error_rad2/1"},
                                     {"covariance_yy_standard_error_rad2", "covariance_standard_error_rad2/2"},
                                     {"rays_launched", "counters/launched"},
                                     {"rays_dropped", "counters/dropped"},
                                     {"rays_negative_focus", "counters/negative_focus"},
                                     {"conoid_z_max", "against_conoid/z_max"},
                                     {"conoid_relative_frobenius", "against_conoid/relative_frobenius"},
                                     {"conoid_semi_major_relative_error", "against_conoid/semi_axis_errors/0"},
                                     {"conoid_semi_minor_relative_error", "against_conoid/semi_axis_errors/1"},
                                     {"conoid_minor_axis_error_arcmin", "against_conoid/minor_axis_error_arcmin"},
                                     {"conoid_orientation_error_deg", "against_conoid/orientation_error_deg"},
                                     {"conoid_bures_wasserstein_arcmin", "against_conoid/bures_wasserstein_arcmin"},
                                     {"closed_form_z_max", "against_closed_form/z_max"},
                                     {"closed_form_relative_frobenius", "against_closed_form/relative_frobenius"}};

constexpr CsvColumn view_columns[] = {{"lens", "lens"},
                                      {"eccentricity_deg", "eccentricity_deg"},
                                      {"direction_deg", "direction_deg"},
                                      {"distance_m", "distance_m"},
                                      {"blur_major_D", "blur_D/0"},
                                      {"blur_minor_D", "blur_D/1"},
                                      {"order", "order"},
                                      {"relative_order", "relative_order"},
                                      {"limit_relative", "limit_relative"},
                                      {"previous_unscaled_error", "previous_unscaled_error"}};

constexpr CsvColumn pupil_columns[] = {{"pupil_mm", "pupil_mm"},
                                       {"rays_lost", "rays_lost"},
                                       {"real_semi_major_arcmin", "real_semi_axes_arcmin/0"},
                                       {"real_semi_minor_arcmin", "real_semi_axes_arcmin/1"}};

constexpr CsvColumn first_order_columns[] = {{"first_order_relative_frobenius", "relative_frobenius"},
                                             {"first_order_defocus_D", "defocus_D"}};

constexpr CsvColumn error_columns[] = {{"relative_frobenius", "relative_frobenius"},
                                       {"semi_major_error_arcmin", "semi_axes_arcmin/0"},
                                       {"semi_minor_error_arcmin", "semi_axes_arcmin/1"},
                                       {"half_width_error_arcmin", "half_width_arcmin"},
                                       {"defocus_error_D", "defocus_D"}};

template <std::size_t N>
void add_headings(CsvWriter& csv, const CsvColumn (&columns)[N]) {
  for (const CsvColumn& column : columns) csv.text(column.heading);
}

template <std::size_t N>
void add_fields(CsvWriter& csv, const Json& json, const CsvColumn (&columns)[N]) {
  for (const CsvColumn& column : columns) {
    if (const auto number = number_at(json, column.path)) {
      csv.number(*number);
    } else {
      csv.text(text_at(json, column.path));
    }
  }
}

}  // namespace

std::string lens_study_csv(const Json& section) {
  CsvWriter csv;
  add_headings(csv, view_columns);
  csv.text("status");
  add_headings(csv, pupil_columns);
  csv.text("method");
  add_headings(csv, first_order_columns);
  add_headings(csv, error_columns);
  csv.end_row();
  for (const Json& view : array_at(section, "views"))
    for (const Json& pupil : array_at(view, "pupils"))
      for (const StudyMethod& method : study_methods) {
        add_fields(csv, view, view_columns);
        csv.text("ok");
        add_fields(csv, pupil, pupil_columns);
        csv.text(method.key);
        add_fields(csv, value_at(view, std::string("first_order/") + method.key), first_order_columns);
        add_fields(csv, value_at(pupil, method.key), error_columns);
        csv.end_row();
      }
  for (const Json& gaze : array_at(section, "gazes")) {
    if (text_at(gaze, "status") == "ok") continue;
    add_fields(csv, gaze, view_columns);
    csv.text(text_at(gaze, "status"));
    csv.empty(std::size(pupil_columns) + 1 + std::size(first_order_columns) + std::size(error_columns));
    csv.end_row();
  }
  return csv.table();
}

std::string ellipses_csv(const Json& report) {
  CsvWriter csv;
  add_headings(csv, case_columns);
  add_headings(csv, ray_columns);
  csv.end_row();
  for (const Json& item : array_at(report, "ellipses/cases"))
    for (const Json& rays : array_at(item, "rays")) {
      add_fields(csv, item, case_columns);
      add_fields(csv, rays, ray_columns);
      csv.end_row();
    }
  return csv.table();
}

}  // namespace sturm
