#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/csv.h"

namespace sturm {

/// A column that a reader asks a table for.
struct CsvColumn {
  std::string name;                       ///< as documents and messages have it
  std::vector<std::string_view> aliases;  ///< what people write as well; letters and digits in lower case
};

/// A table with a line of column names, as people and spreadsheets write it: the separator is told from the heading
/// (csv_dialect_of), UTF-16 and Windows-1252 are understood, and of a column's name only letters and digits count, in
/// either case.
class CsvTable {
 public:
  /// `bytes` are the contents of `file`, which messages name. Throws InputError where nothing stands in them.
  CsvTable(std::string bytes, std::string file);
  CsvTable(const CsvTable&) = delete;  // the reader looks into the text
  CsvTable& operator=(const CsvTable&) = delete;

  /// The column's place; none where the table has none. Throws InputError where two could be meant.
  std::optional<std::size_t> find(const CsvColumn& column) const;

  /// The next row that holds anything. Throws InputError for one that holds more than the heading has names for: a
  /// decimal comma in a table with commas would shift the fields.
  std::optional<CsvRow> next();

  /// Throws InputError about a line of the table.
  [[noreturn]] void fail(int line, const std::string& value, const std::string& expected) const;

  const std::string& file() const { return file_; }
  const CsvRow& heading() const { return heading_; }

 private:
  std::string text_, file_;
  CsvReader reader_;
  CsvRow heading_;
};

}  // namespace sturm
