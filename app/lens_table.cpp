#include "app/lens_table.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/text_columns.h"
#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "io/json/values.h"

namespace sturm {

namespace {

constexpr const char* no_number = "–";

std::string number(const Json& value, const char* format) {
  return value.is_number() ? formatted(format, value.get<double>()) : no_number;
}

/// "-2.00 -1.50 x 30".
std::string power_text(const Json& power) {
  if (!power.is_object()) return no_number;
  const std::string sphere = number(power["sphere_D"], "%+.2f");
  constexpr double shown_D = 0.005;  // less is written as 0
  if (!power["axis_deg"].is_number() || std::abs(power["cylinder_D"].get<double>()) < shown_D) return sphere;
  return sphere + number(power["cylinder_D"], " %+.2f") + number(power["axis_deg"], " x %.0f");
}

/// The largest size of an error over all gazes, and where.
std::string largest_error(const Json& gazes, const char* key) {
  std::optional<double> largest;
  const Json* where = nullptr;
  for (const Json& gaze : gazes) {
    const Json& error = gaze["error"];
    if (!error.is_object() || !error[key].is_number()) continue;
    const double value = error[key].get<double>();
    if (largest && std::abs(value) <= std::abs(*largest)) continue;
    largest = value;
    where = &gaze["gaze_deg"];
  }
  if (!largest) return no_number;
  return formatted("%+.2f", *largest) + " at " + plain_number((*where)[0].get<double>(), 4) + "," +
         plain_number((*where)[1].get<double>(), 4);
}

std::size_t lost(const Json& gazes) {
  std::size_t count = 0;
  for (const Json& gaze : gazes) count += gaze["status"] != "ok";
  return count;
}

}  // namespace

std::string lens_table(const std::vector<NamedLensReport>& lenses) {
  std::vector<std::vector<std::string>> rows{{"lens", "back vertex power [D]", "index", "centre [mm]", "edge [mm]",
                                              "largest mean error [D]", "largest cylinder of the error [D]",
                                              "gazes lost"}};
  for (const NamedLensReport& lens : lenses) {
    const Json &report = lens.report, &edge = report["thickness"], &gazes = report["gazes"];
    rows.push_back({lens.name, power_text(report["back_vertex"]), number(report["refractive_index"], "%.3f"),
                    number(edge["center_mm"], "%.2f"),
                    edge["edge_min_mm"].is_number()
                        ? number(edge["edge_min_mm"], "%.2f") + " … " + number(edge["edge_max_mm"], "%.2f")
                        : no_number,
                    largest_error(gazes, "M_D"), largest_error(gazes, "astigmatism_D"),
                    std::to_string(lost(gazes)) + " of " + std::to_string(gazes.size())});
  }
  return text_columns(rows);
}

std::string lens_csv(const std::vector<NamedLensReport>& lenses) {
  struct Column {
    const char *name, *part, *key;
  };
  constexpr Column columns[] = {{"sphere_D", "power", "sphere_D"},
                                {"cylinder_D", "power", "cylinder_D"},
                                {"axis_deg", "power", "axis_deg"},
                                {"error_M_D", "error", "M_D"},
                                {"error_J0_D", "error", "J0_D"},
                                {"error_J45_D", "error", "J45_D"},
                                {"error_astigmatism_D", "error", "astigmatism_D"},
                                {"prism_cm_per_m", "prism", "prism_cm_per_m"},
                                {"prism_base_deg", "prism", "base_deg"}};
  CsvWriter csv;
  for (const char* column : {"lens", "gaze_azimuth_deg", "gaze_elevation_deg", "status"}) csv.text(column);
  for (const Column& column : columns) csv.text(column.name);
  csv.end_row();
  for (const NamedLensReport& lens : lenses)
    for (const Json& gaze : lens.report["gazes"]) {
      csv.text(lens.name);
      for (const Json& angle : gaze["gaze_deg"]) csv.number(angle.get<double>());
      csv.text(gaze["status"].get<std::string>());
      for (const auto& [name, part, key] : columns) {
        const Json& numbers = gaze[part];
        csv.number(numbers.is_object() ? number_or_none(numbers[key]) : std::nullopt);
      }
      csv.end_row();
    }
  return csv.table();
}

}  // namespace sturm
