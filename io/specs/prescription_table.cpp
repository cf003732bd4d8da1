#include "io/specs/prescription_table.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "io/files/error.h"
#include "io/files/text_file.h"
#include "lensmodel/power_matrix.h"

namespace sturm {

namespace {

std::vector<std::string> fields_of(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> fields;
  std::stringstream text(line);
  for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
  return fields;
}

/// The lines of a table, read by the names of their columns.
class Table {
 public:
  Table(const std::filesystem::path& file, const std::string& heading)
      : file_(file.string()), columns_(fields_of(heading)) {}

  void start_line(int number, const std::string& line) {
    number_ = number;
    fields_ = fields_of(line);
  }

  const std::string& text(const char* column) const {
    const auto at = std::find(columns_.begin(), columns_.end(), column);
    if (at == columns_.end()) throw InputError(file_, "", "", std::string("a column ") + column);
    const auto index = static_cast<std::size_t>(at - columns_.begin());
    if (index >= fields_.size() || fields_[index].empty()) fail("", std::string("a value in column ") + column);
    return fields_[index];
  }

  double number(const char* column) const {
    const std::string& field = text(column);
    double value = 0.0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || end != field.data() + field.size())
      fail(field, std::string("a number in column ") + column);
    return value;
  }

  [[noreturn]] void fail(const std::string& value, const std::string& expected) const {
    throw InputError(file_, "line " + std::to_string(number_), value, expected);
  }

 private:
  std::string file_;
  std::vector<std::string> columns_, fields_;
  int number_ = 0;
};

}  // namespace

std::vector<TabledPrescription> read_prescription_table(const std::filesystem::path& file, double vertex_distance_m) {
  const auto contents = file_contents(file);
  if (!contents) throw InputError(file.string(), "", "", "a file that can be read");
  std::stringstream lines(*contents);
  std::vector<TabledPrescription> eyes;
  std::optional<Table> table;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line.front() == '#' || line == "\r") continue;
    if (!table) {
      table.emplace(file, line);
      continue;
    }
    table->start_line(number, line);
    const Prescription rx{table->number("sph_D"), table->number("cyl_D"), table->number("axis_deg"), vertex_distance_m};
    try {
      validate(rx);
      power_at_cornea(rx);
    } catch (const std::logic_error& error) {  // std::invalid_argument, std::domain_error
      table->fail(line, std::string("a prescription that can be computed: ") + error.what());
    }
    eyes.push_back({table->text("id") + "-" + table->text("eye"), rx});
  }
  if (eyes.empty()) throw InputError(file.string(), "", "", "a table with at least one prescription");
  return eyes;
}

}  // namespace sturm
