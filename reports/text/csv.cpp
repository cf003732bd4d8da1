#include "reports/text/csv.h"

#include <charconv>
#include <string_view>

#include "compare/studies/lens/lens_study_errors.h"

namespace sturm {

namespace {

constexpr const char* end_of_line = "\r\n";

std::string exact(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string field(const Number& number) {
  return number ? exact(*number) : std::string();
}

std::string field(const std::optional<StoredDistance>& distance) {
  return distance && distance->is_infinite() ? "inf" : field(finite(distance));
}

constexpr std::string_view lens_headings =
    "lens,eccentricity_deg,direction_deg,distance_m,blur_major_D,blur_minor_D,order,relative_order,limit_relative,"
    "previous_unscaled_error,status,pupil_mm,rays_lost,real_semi_major_arcmin,real_semi_minor_arcmin,method,"
    "first_order_relative_frobenius,first_order_defocus_D,relative_frobenius,semi_major_error_arcmin,"
    "semi_minor_error_arcmin,half_width_error_arcmin,defocus_error_D";

/// The columns up to the status.
std::string view_fields(const LensStudyView& view) {
  std::string text = quoted(view.lens) + "," + field(view.eccentricity_deg) + "," + field(view.direction_deg) + "," +
                     field(view.distance_m);
  for (const Number& number : {view.blur_D[0], view.blur_D[1], view.order, view.relative_order, view.limit_relative,
                               view.previous_unscaled_error})
    text += "," + field(number);
  return text;
}

std::string pupil_fields(const LensPupil& pupil) {
  const auto axes = pupil.real_semi_axes_arcmin.value_or(std::array<Number, 2>{});
  return field(pupil.pupil_mm) + "," + field(pupil.rays_lost) + "," + field(axes[0]) + "," + field(axes[1]);
}

/// The columns after the method.
std::string error_fields(const LensStudyView& view, const LensPupil& pupil, const StudyMethod& method) {
  const FirstOrderError first_order =
      method.first_order ? (view.first_order.*method.first_order).value_or(FirstOrderError{}) : FirstOrderError{};
  const MethodError error = (pupil.*method.error).value_or(MethodError{});
  std::string text = field(first_order.relative_frobenius) + "," + field(first_order.defocus_D);
  for (const Number& number : {error.relative_frobenius, error.semi_axes_arcmin[0], error.semi_axes_arcmin[1],
                               error.half_width_arcmin, error.defocus_D})
    text += "," + field(number);
  return text;
}

}  // namespace

std::string lens_study_csv(const LensFindings& found) {
  std::string csv(lens_headings);
  csv += end_of_line;
  for (const LensStudyView& view : found.views)
    for (const LensPupil& pupil : view.pupils)
      for (const StudyMethod& method : study_methods)
        csv += view_fields(view) + ",ok," + pupil_fields(pupil) + "," + method.key + "," +
               error_fields(view, pupil, method) + end_of_line;
  constexpr std::size_t columns_after_status = 12;
  for (const LensGaze& gaze : found.gazes) {
    if (gaze.status == "ok") continue;
    LensStudyView place;
    place.lens = gaze.lens;
    place.eccentricity_deg = gaze.eccentricity_deg;
    place.direction_deg = gaze.direction_deg;
    csv += view_fields(place) + "," + quoted(gaze.status) + std::string(columns_after_status, ',') + end_of_line;
  }
  return csv;
}

}  // namespace sturm
