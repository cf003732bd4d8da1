#include "reports/text/csv.h"

#include <array>
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

template <std::size_t N>
void add_headings(CsvWriter& csv, const CsvColumn (&columns)[N]) {
  for (const CsvColumn& column : columns) csv.text(column.heading);
}

template <std::size_t N>
void add_fields(CsvWriter& csv, const Json& json, const CsvColumn (&columns)[N]) {
  for (const CsvColumn& column : columns) {
    if (const auto number = number_at(json, column.path)) {
      csv.number(number);
    } else {
      csv.text(text_at(json, column.path));
    }
  }
}

constexpr std::array view_headings{"lens",           "eccentricity_deg",
                                   "direction_deg",  "distance_m",
                                   "blur_major_D",   "blur_minor_D",
                                   "order",          "relative_order",
                                   "limit_relative", "previous_unscaled_error",
                                   "status"};
constexpr std::array method_headings{"pupil_mm",
                                     "rays_lost",
                                     "real_semi_major_arcmin",
                                     "real_semi_minor_arcmin",
                                     "method",
                                     "first_order_relative_frobenius",
                                     "first_order_defocus_D",
                                     "relative_frobenius",
                                     "semi_major_error_arcmin",
                                     "semi_minor_error_arcmin",
                                     "half_width_error_arcmin",
                                     "defocus_error_D"};

void add_distance(CsvWriter& csv, const std::optional<StoredDistance>& distance) {
  if (distance && distance->is_infinite()) {
    csv.text("inf");
  } else {
    csv.number(finite(distance));
  }
}

void add_view(CsvWriter& csv, const LensStudyView& view, std::string_view status) {
  csv.text(view.lens);
  csv.number(view.eccentricity_deg);
  csv.number(view.direction_deg);
  add_distance(csv, view.distance_m);
  for (const Number& number : {view.blur_D[0], view.blur_D[1], view.order, view.relative_order, view.limit_relative,
                               view.previous_unscaled_error})
    csv.number(number);
  csv.text(status);
}

void add_method(CsvWriter& csv, const LensStudyView& view, const LensPupil& pupil, const StudyMethod& method) {
  const auto axes = pupil.real_semi_axes_arcmin.value_or(std::array<Number, 2>{});
  for (const Number& number : {pupil.pupil_mm, pupil.rays_lost, axes[0], axes[1]}) csv.number(number);
  csv.text(method.key);
  const FirstOrderError first_order =
      method.first_order ? (view.first_order.*method.first_order).value_or(FirstOrderError{}) : FirstOrderError{};
  const MethodError error = (pupil.*method.error).value_or(MethodError{});
  for (const Number& number :
       {first_order.relative_frobenius, first_order.defocus_D, error.relative_frobenius, error.semi_axes_arcmin[0],
        error.semi_axes_arcmin[1], error.half_width_arcmin, error.defocus_D})
    csv.number(number);
}

}  // namespace

std::string lens_study_csv(const LensFindings& found) {
  CsvWriter csv;
  for (const char* heading : view_headings) csv.text(heading);
  for (const char* heading : method_headings) csv.text(heading);
  csv.end_row();
  for (const LensStudyView& view : found.views)
    for (const LensPupil& pupil : view.pupils)
      for (const StudyMethod& method : study_methods) {
        add_view(csv, view, "ok");
        add_method(csv, view, pupil, method);
        csv.end_row();
      }
  for (const LensGaze& gaze : found.gazes) {
    if (gaze.status == "ok") continue;
    LensStudyView place;
    place.lens = gaze.lens;
    place.eccentricity_deg = gaze.eccentricity_deg;
    place.direction_deg = gaze.direction_deg;
    add_view(csv, place, gaze.status);
    csv.empty(method_headings.size());
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
