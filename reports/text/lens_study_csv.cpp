#include "reports/text/lens_study_csv.h"

#include <array>
#include <string_view>

#include "compare/studies/lens/lens_study_errors.h"
#include "io/files/csv.h"

namespace sturm {

namespace {

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
  for (const Number& number : {pupil.pupil_mm, Number(pupil.rays_lost), axes[0], axes[1]}) csv.number(number);
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

}  // namespace sturm
