#include "reports/text/csv.h"

#include <charconv>
#include <string_view>

#include "compare/studies/lens/lens_study_errors.h"
#include "io/json/stored.h"

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

std::string field(const Json& json, std::string_view path) {
  if (const auto number = number_at(json, path)) return exact(*number);
  return quoted(text_at(json, path));
}

struct CsvColumn {
  std::string_view heading, path;
};

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
void add_headings(std::string& csv, const CsvColumn (&columns)[N]) {
  for (const CsvColumn& column : columns) csv.append(csv.empty() ? "" : ",").append(column.heading);
}

template <std::size_t N>
std::string fields(const Json& json, const CsvColumn (&columns)[N]) {
  std::string text;
  for (const CsvColumn& column : columns) text.append(",").append(field(json, column.path));
  return text;
}

}  // namespace

std::string lens_study_csv(const Json& section) {
  std::string csv;
  add_headings(csv, view_columns);
  csv += ",status";
  add_headings(csv, pupil_columns);
  csv += ",method";
  add_headings(csv, first_order_columns);
  add_headings(csv, error_columns);
  csv += end_of_line;
  for (const Json& view : array_at(section, "views"))
    for (const Json& pupil : array_at(view, "pupils"))
      for (const StudyMethod& method : study_methods) {
        const std::string first_order = std::string("first_order/") + method.key;
        csv += fields(view, view_columns).substr(1) + ",ok" + fields(pupil, pupil_columns) + "," + method.key +
               fields(value_at(view, first_order), first_order_columns) +
               fields(value_at(pupil, method.key), error_columns) + end_of_line;
      }
  for (const Json& gaze : array_at(section, "gazes")) {
    if (text_at(gaze, "status") == "ok") continue;
    csv += fields(gaze, view_columns).substr(1) + "," + quoted(text_at(gaze, "status")) +
           std::string(std::size(pupil_columns) + 1 + std::size(first_order_columns) + std::size(error_columns), ',') +
           end_of_line;
  }
  return csv;
}

}  // namespace sturm
