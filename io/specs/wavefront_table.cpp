#include "io/specs/wavefront_table.h"

#include <cmath>
#include <optional>
#include <utility>

#include "io/files/csv_table.h"
#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/files/text_file.h"

namespace sturm {

namespace {

constexpr int most_coefficients = 231;  // radial order 20

/// The place of each coefficient's column; none where the table has none.
std::vector<std::optional<std::size_t>> coefficient_columns(const CsvTable& table) {
  std::vector<std::optional<std::size_t>> columns;
  std::size_t used = 0;
  for (int j = 0; j < most_coefficients; ++j) {
    columns.push_back(table.find({"c" + std::to_string(j), {}}));
    if (columns.back()) used = columns.size();
  }
  columns.resize(used);
  return columns;
}

/// A row's coefficients; none where one is missing.
std::optional<std::vector<double>> coefficients_of(const CsvRow& row, const CsvTable& table,
                                                   const std::vector<std::optional<std::size_t>>& columns) {
  std::vector<double> coefficients(columns.size(), 0.0);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (!columns[j]) continue;
    const std::string cell = *columns[j] < row.fields.size() ? row.fields[*columns[j]] : "";
    if (cell.empty()) return std::nullopt;
    const std::optional<double> value = csv_number(cell);
    if (!value || std::isinf(*value))
      table.fail(row.line, readable(cell, 80), "a number in column c" + std::to_string(j));
    if (std::isnan(*value)) return std::nullopt;
    coefficients[j] = *value;
  }
  return coefficients;
}

}  // namespace

std::vector<std::vector<double>> read_wavefront_table(const std::filesystem::path& file) {
  auto contents = file_contents(file);
  if (!contents) throw InputError(file.string(), "", "", "a file that can be read");
  CsvTable table(std::move(*contents), file.string());
  const auto columns = coefficient_columns(table);
  if (columns.empty())
    table.fail(table.heading().line, "the columns " + readable(table.heading().text, 80), "columns c0, c1, …");
  std::vector<std::vector<double>> eyes;
  while (const std::optional<CsvRow> row = table.next())
    if (auto coefficients = coefficients_of(*row, table, columns)) eyes.push_back(std::move(*coefficients));
  if (eyes.empty()) throw InputError(file.string(), "", "", "a table with at least one measured eye");
  return eyes;
}

}  // namespace sturm
