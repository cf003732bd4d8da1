#include "io/specs/prescription_table.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "io/files/csv.h"
#include "io/files/error.h"
#include "io/files/text_file.h"
#include "lensmodel/power_matrix.h"

namespace sturm {

namespace {

/// The rows of a table, read by the names of their columns.
class Table {
 public:
  Table(std::string file, CsvRow heading) : file_(std::move(file)), columns_(std::move(heading.fields)) {}

  void start_row(CsvRow row) { row_ = std::move(row); }

  const std::string& text(const char* column) const {
    const auto at = std::find(columns_.begin(), columns_.end(), column);
    if (at == columns_.end()) throw InputError(file_, "", "", std::string("a column ") + column);
    const auto index = static_cast<std::size_t>(at - columns_.begin());
    if (index >= row_.fields.size() || row_.fields[index].empty()) fail("", std::string("a value in column ") + column);
    return row_.fields[index];
  }

  double number(const char* column) const {
    const std::string& field = text(column);
    const std::optional<double> value = csv_number(field);
    if (!value) fail(field, std::string("a number in column ") + column);
    return *value;
  }

  [[noreturn]] void fail(const std::string& value, const std::string& expected) const {
    throw InputError(file_, "line " + std::to_string(row_.line), value, expected);
  }

 private:
  std::string file_;
  std::vector<std::string> columns_;
  CsvRow row_;
};

}  // namespace

std::vector<TabledPrescription> read_prescription_table(const std::filesystem::path& file, double vertex_distance_m) {
  const auto contents = file_contents(file);
  if (!contents) throw InputError(file.string(), "", "", "a file that can be read");
  CsvReader rows(*contents, file.string());
  std::vector<TabledPrescription> eyes;
  std::optional<Table> table;
  while (std::optional<CsvRow> row = rows.next()) {
    if (!table) {
      table.emplace(file.string(), std::move(*row));
      continue;
    }
    const std::string_view line = row->text;
    table->start_row(std::move(*row));
    const Prescription rx{table->number("sph_D"), table->number("cyl_D"), table->number("axis_deg"), vertex_distance_m};
    try {
      validate(rx);
      power_at_cornea(rx);
    } catch (const std::logic_error& error) {  // std::invalid_argument, std::domain_error
      table->fail(std::string(line), std::string("a prescription that can be computed: ") + error.what());
    }
    eyes.push_back({table->text("id") + "-" + table->text("eye"), rx});
  }
  if (eyes.empty()) throw InputError(file.string(), "", "", "a table with at least one prescription");
  return eyes;
}

}  // namespace sturm
