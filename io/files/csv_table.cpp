#include "io/files/csv_table.h"

#include <algorithm>
#include <utility>

#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "io/files/readable_text.h"
#include "io/files/text_encoding.h"

namespace sturm {

namespace {

std::string letters_and_digits(std::string_view name) {
  std::string result;
  for (const char c : lower_case(name))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) result += c;
  return result;
}

}  // namespace

CsvTable::CsvTable(std::string bytes, std::string file)
    : text_(utf8_text(std::move(bytes))), file_(std::move(file)), reader_(text_, file_, csv_dialect_of(text_)) {
  std::optional<CsvRow> row = reader_.next();
  if (!row) throw InputError(file_, "", "an empty file", "a table with a line of column names");
  heading_ = std::move(*row);
}

std::optional<std::size_t> CsvTable::find(const CsvColumn& column) const {
  const auto& names = heading_.fields;
  if (const auto exact = std::ranges::find(names, column.name); exact != names.end())
    return static_cast<std::size_t>(exact - names.begin());
  const std::string wanted = letters_and_digits(column.name);
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = letters_and_digits(names[i]);
    if (name != wanted && std::ranges::find(column.aliases, name) == column.aliases.end()) continue;
    if (found)
      fail(heading_.line, "columns \"" + names[*found] + "\" and \"" + names[i] + "\"",
           "one column for " + column.name + ", or one of exactly this name");
    found = i;
  }
  return found;
}

std::optional<CsvRow> CsvTable::next() {
  while (std::optional<CsvRow> row = reader_.next()) {
    if (std::ranges::all_of(row->fields, [](const std::string& field) { return field.empty(); })) continue;
    while (row->fields.size() > heading_.fields.size() && row->fields.back().empty()) row->fields.pop_back();
    if (row->fields.size() > heading_.fields.size())
      fail(row->line, readable(row->text, 80),
           "at most " + std::to_string(heading_.fields.size()) +
               " fields, as in the heading (numbers with a decimal comma need quotes, or semicolons between fields)");
    return row;
  }
  return std::nullopt;
}

void CsvTable::fail(int line, const std::string& value, const std::string& expected) const {
  throw InputError(file_, "line " + std::to_string(line), value, expected);
}

}  // namespace sturm
