#include "app/psf_table.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "app/text_columns.h"
#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "io/json/values.h"

namespace sturm {

namespace {

using Number = std::optional<double>;

/// Distances are numbers or "inf"; none where the defocus was given itself.
Number distance_of(const Json& spread) {
  const Json& distance = spread["distance_m"];
  return distance.is_string() ? Number(std::numeric_limits<double>::infinity()) : number_or_none(distance);
}

std::string shown(const Number& value, const char* format) {
  return value ? formatted(format, *value) : "–";
}

std::string shown_distance(const Number& distance_m) {
  return distance_m ? plain_number(*distance_m, 4) : "–";
}

/// What the columns of all documents together are about, ascending.
struct Columns {
  std::set<double> frequencies_cpd, directions_deg, shares;
};

Columns columns_of(const std::vector<NamedSpreads>& documents) {
  Columns columns;
  for (const NamedSpreads& document : documents) {
    for (const Json& frequency : document.result["mtf"]["frequencies_cpd"])
      columns.frequencies_cpd.insert(frequency.get<double>());
    for (const Json& direction : document.result["mtf"]["directions_deg"])
      columns.directions_deg.insert(direction.get<double>());
    for (const Json& spread : document.result["results"])
      for (const Json& energy : spread["energy"]) columns.shares.insert(energy["share"].get<double>());
  }
  return columns;
}

Number radius_of(const Json& spread, double share) {
  for (const Json& energy : spread["energy"])
    if (energy["share"] == share) return number_or_none(energy["radius_about_chief_ray_arcmin"]);
  return std::nullopt;
}

std::optional<std::size_t> place_of(double value, const Json& list) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i] == value) return i;
  return std::nullopt;
}

Number transfer_in(const Json& result, const Json& spread, double frequency, double direction) {
  const auto row = place_of(direction, result["mtf"]["directions_deg"]);
  const auto column = place_of(frequency, result["mtf"]["frequencies_cpd"]);
  return row && column ? number_or_none(spread["mtf"][*row][*column]) : std::nullopt;
}

/// The mean over the directions.
Number transfer_of(const Json& result, const Json& spread, double frequency) {
  const auto column = place_of(frequency, result["mtf"]["frequencies_cpd"]);
  const Json& rows = spread["mtf"];
  if (!column || rows.empty()) return std::nullopt;
  double sum = 0.0;
  for (const Json& row : rows) sum += row[*column].get<double>();
  return sum / static_cast<double>(rows.size());
}

}  // namespace

std::string psf_table(const std::vector<NamedSpreads>& documents) {
  const Columns columns = columns_of(documents);
  const bool several = documents.size() > 1;
  std::vector<std::vector<std::string>> rows(1);
  if (several) rows[0].push_back("document");
  for (const char* name : {"distance [m]", "defocus [D]", "light", "model", "Strehl", "visual Strehl"})
    rows[0].push_back(name);
  for (const double share : columns.shares) rows[0].push_back("radius of " + plain_number(100.0 * share, 4) + " % [′]");
  for (const double frequency : columns.frequencies_cpd) rows[0].push_back("MTF " + plain_number(frequency, 4) + "/°");
  for (const NamedSpreads& document : documents)
    for (const Json& spread : document.result["results"]) {
      std::vector<std::string> row;
      if (several) row.push_back(document.name);
      row.insert(row.end(), {shown_distance(distance_of(spread)), shown(number_or_none(spread["defocus_D"]), "%+.2f"),
                             spread["light"].get<std::string>(), spread["model"].get<std::string>(),
                             shown(number_or_none(spread["strehl"]), "%.4f"),
                             shown(number_or_none(spread["visual_strehl"]), "%.4f")});
      for (const double share : columns.shares) row.push_back(shown(radius_of(spread, share), "%.2f"));
      for (const double frequency : columns.frequencies_cpd)
        row.push_back(shown(transfer_of(document.result, spread, frequency), "%.3f"));
      rows.push_back(std::move(row));
    }
  return text_columns(rows);
}

std::string psf_csv(const std::vector<NamedSpreads>& documents) {
  const Columns columns = columns_of(documents);
  constexpr const char* numbers[] = {"defocus_D", "accommodation_D", "strehl", "strehl_peak", "visual_strehl"};
  CsvWriter csv;
  for (const char* column : {"document", "light", "target", "model", "distance_m"}) csv.text(column);
  for (const char* column : numbers) csv.text(column);
  for (const double share : columns.shares) csv.text("radius_" + plain_number(share, 6) + "_arcmin");
  for (const double frequency : columns.frequencies_cpd) {
    csv.text("mtf_" + plain_number(frequency, 6) + "cpd");
    for (const double direction : columns.directions_deg)
      csv.text("mtf_" + plain_number(frequency, 6) + "cpd_" + plain_number(direction, 6) + "deg");
  }
  csv.end_row();
  for (const NamedSpreads& document : documents)
    for (const Json& spread : document.result["results"]) {
      csv.text(document.name);
      csv.text(spread["light"].get<std::string>());
      csv.number(number_or_none(spread["target"]));
      csv.text(spread["model"].get<std::string>());
      csv.number(distance_of(spread));
      for (const char* column : numbers) csv.number(number_or_none(spread[column]));
      for (const double share : columns.shares) csv.number(radius_of(spread, share));
      for (const double frequency : columns.frequencies_cpd) {
        csv.number(transfer_of(document.result, spread, frequency));
        for (const double direction : columns.directions_deg)
          csv.number(transfer_in(document.result, spread, frequency, direction));
      }
      csv.end_row();
    }
  return csv.table();
}

}  // namespace sturm
