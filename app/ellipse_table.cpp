#include "app/ellipse_table.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/text_columns.h"
#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "io/json/values.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double clear_semi_axis_arcmin = 0.5;  // as wide as the stroke of a letter that a sharp eye just reads
constexpr double alike_D = 0.01;                // powers are written in steps of 0.25 D
constexpr const char* none = "–";

/// Major and minor, in units of `scale`. What rounding leaves of a zero is one.
std::string axes(const Json& pair, double scale = 1.0) {
  if (!pair.is_array() || !pair[0].is_number()) return none;
  const auto size = [&](const Json& axis) {
    const double value = scale * axis.get<double>();
    return plain_number(value < 1e-9 ? 0.0 : value, 4);
  };
  return size(pair[0]) + " x " + size(pair[1]);
}

/// A line's direction, (0°, 180°] in whole degrees.
std::string direction(const Json& degrees) {
  const auto whole = std::lround(degrees.get<double>());
  return std::to_string(whole <= 0 ? whole + 180 : whole) + "°";
}

/// To a tenth of a degree, (0°, 180°].
std::string degrees(const Json& value) {
  if (!value.is_number()) return none;
  const double tenths = std::round(10.0 * value.get<double>());
  return plain_number((tenths <= 0.0 ? tenths + 1800.0 : tenths) / 10.0, 4) + "°";
}

/// "at 0.52 m", "far away", "nowhere": where a focus of this vergence lies.
std::string place(const Json& line) {
  const double vergence_D = line.at("vergence_D").get<double>();
  if (vergence_D < -alike_D) return "nowhere";
  if (vergence_D < alike_D) return "far away";
  return "at " + plain_number(1.0 / vergence_D, 2) + " m";
}

std::string where_clear(const Json& lines) {
  if (!lines.is_array()) return "";
  const Json &near = lines[0], &far = lines[1];
  if (!near.at("vergence_D").is_number()) return "";
  const bool point = !near.at("orientation_deg").is_number() ||
                     near.at("vergence_D").get<double>() - far.at("vergence_D").get<double>() < alike_D;
  if (point) return "clear " + place(near);
  return "lines along " + direction(near.at("orientation_deg")) + " clear " + place(near) + ", along " +
         direction(far.at("orientation_deg")) + " " + place(far);
}

std::string how_blurred(const Json& result) {
  const Json& semi_axes = result.at("semi_axes_arcmin");
  if (!semi_axes.is_array() || !semi_axes[0].is_number()) return "no ellipse";
  const double major = semi_axes[0].get<double>(), minor = semi_axes[1].get<double>();
  if (major <= clear_semi_axis_arcmin) return "clear";
  if (!result.at("orientation_deg").is_number() || major - minor <= clear_semi_axis_arcmin) return "blurred evenly";
  return "blurred along " + direction(result.at("orientation_deg"));
}

using Row = std::vector<std::string>;

std::string gaze_text(const Target& target) {
  return plain_number(target.azimuth / radians_per_degree, 4) + "," +
         plain_number(target.elevation / radians_per_degree, 4);
}

void put_result(CsvWriter& csv, const Target& target, const Json& r) {
  const auto put = [&](const Json& value) { csv.number(number_or_none(value)); };
  csv.text(exact_number(target.distance_m));
  csv.number(target.azimuth / radians_per_degree, 15);
  csv.number(target.elevation / radians_per_degree, 15);
  csv.text(r.at("method").get_ref<const std::string&>());
  csv.text(r.at("status").get_ref<const std::string&>());
  put(r.at("accommodation_D"));
  for (const char* key : {"semi_axes_arcmin", "semi_axes_D", "semi_axes_m"})
    for (const std::size_t i : {0, 1}) put(r.at(key).is_array() ? r.at(key)[i] : Json());
  put(r.at("orientation_deg"));
  put(r.at("orientation_tabo_deg"));
  const Json lines = r.value("focal_lines", Json());
  for (const std::size_t i : {0, 1})
    for (const char* key : {"vergence_D", "orientation_deg"}) put(lines.is_array() ? lines[i].at(key) : Json());
  csv.text(ellipse_in_words(r));
  csv.end_row();
}

}  // namespace

std::string ellipse_in_words(const Json& result) {
  if (result.at("status") != "ok") {
    std::string reason = result.at("status").get<std::string>();
    std::replace(reason.begin(), reason.end(), '_', ' ');
    return "no ellipse: " + reason;
  }
  const std::string clear = where_clear(result.value("focal_lines", Json()));
  return how_blurred(result) + (clear.empty() ? "" : "; " + clear);
}

std::string ellipse_table(const std::vector<AnsweredQuery>& answers) {
  const bool several = answers.size() > 1;
  bool gazes = false, methods = false;
  for (const AnsweredQuery& one : answers) {
    gazes = gazes || std::any_of(one.query.targets.begin(), one.query.targets.end(),
                                 [](const Target& t) { return t.azimuth != 0.0 || t.elevation != 0.0; });
    methods = methods || one.query.methods.size() > 1;
  }
  std::vector<Row> rows(1);
  if (several) rows[0].emplace_back("query");
  rows[0].emplace_back("target [m]");
  if (gazes) rows[0].emplace_back("gaze [deg]");
  if (methods) rows[0].emplace_back("method");
  for (const char* title : {"accommodation [D]", "semi-axes [arcmin]", "[D]", "[mm]", "wearer", "TABO", "in words"})
    rows[0].emplace_back(title);
  for (const AnsweredQuery& one : answers)
    for (const Json& r : one.answer.at("results")) {
      const Target& target = one.query.targets.at(r.at("target").get<std::size_t>());
      Row row;
      if (several) row.push_back(one.name);
      row.push_back(plain_number(target.distance_m));
      if (gazes) row.push_back(gaze_text(target));
      if (methods) row.push_back(r.at("method").get<std::string>());
      row.push_back(r.at("accommodation_D").is_number() ? formatted("%.2f", r.at("accommodation_D").get<double>())
                                                        : none);
      row.push_back(axes(r.at("semi_axes_arcmin")));
      row.push_back(axes(r.at("semi_axes_D")));
      row.push_back(axes(r.at("semi_axes_m"), 1.0 / metres_per_millimetre));
      row.push_back(degrees(r.at("orientation_deg")));
      row.push_back(degrees(r.at("orientation_tabo_deg")));
      row.push_back(ellipse_in_words(r));
      rows.push_back(std::move(row));
    }
  return text_columns(rows);
}

std::string ellipse_csv(const std::vector<AnsweredQuery>& answers) {
  const bool several = answers.size() > 1;
  CsvWriter csv;
  if (several) csv.text("query");
  for (const char* column : {"distance_m", "gaze_azimuth_deg", "gaze_elevation_deg", "method", "status",
                             "accommodation_D", "semi_major_arcmin", "semi_minor_arcmin", "semi_major_D",
                             "semi_minor_D", "semi_major_m", "semi_minor_m", "orientation_deg", "orientation_tabo_deg",
                             "near_line_D", "near_line_deg", "far_line_D", "far_line_deg", "in_words"})
    csv.text(column);
  csv.end_row();
  for (const AnsweredQuery& one : answers)
    for (const Json& r : one.answer.at("results")) {
      if (several) csv.text(one.name);
      put_result(csv, one.query.targets.at(r.at("target").get<std::size_t>()), r);
    }
  return csv.table();
}

}  // namespace sturm
