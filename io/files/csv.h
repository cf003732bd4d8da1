#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// The characters that cut the text of a table into fields.
struct CsvDialect {
  char separator = ',';
  char quote = '"';  ///< stands around a field that holds separators, line ends or quotes (written twice)
};

/// The separator of a table as its first row has it: a semicolon, else a tab, else a comma, each outside of quotes; a
/// blank (runs of blanks count as one) where there is none of them but words stand apart. A first line `sep=X`, which
/// spreadsheets write, names it.
CsvDialect csv_dialect_of(std::string_view text);

/// One row of a table that was read.
struct CsvRow {
  int line = 0;           ///< the number, from 1, of the line that it starts on
  std::string_view text;  ///< the row as it stands in the table, without its line end
  std::vector<std::string> fields;
};

/// Reads a table row by row (RFC 4180). Rows end with CRLF, LF or CR; a byte order mark before the first one is
/// skipped. Blank lines, lines that start with # and a first line `sep=X` are no rows, and blanks (spaces, tabs) around
/// a field are not part of it unless they stand in its quotes.
class CsvReader {
 public:
  /// `text` must outlive the reader and its rows; messages name `file`.
  CsvReader(std::string_view text, std::string file, CsvDialect dialect = {});

  /// The next row; none after the last one. Throws InputError with file and line for a quote that is not closed and for
  /// text behind a closing quote.
  std::optional<CsvRow> next();

 private:
  std::string field();
  std::string quoted_field();
  void skip_blanks();
  bool at_separator() const;  ///< not at the end of the text
  bool at_end_of_field() const;
  void skip_line_end();
  [[noreturn]] void fail(int line, std::string_view value, const std::string& expected) const;

  std::string_view text_;
  std::string file_;
  CsvDialect dialect_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// The number that a field consists of ("1.5", "+1.25", "1,25", "-2e-3", "inf", "nan"); none where it holds anything
/// else. A minus may be U+2212 or a dash, and a comma stands for the decimal point where there is no point.
std::optional<double> csv_number(std::string_view field);

/// Writes a table as RFC 4180 has it: commas, CRLF, quotes where they are needed.
class CsvWriter {
 public:
  void text(std::string_view value);
  /// With as many digits as it needs to read back exactly, or rounded to so many significant ones; none is an empty
  /// field.
  void number(std::optional<double> value);
  void number(std::optional<double> value, int digits);
  void empty(std::size_t fields);
  void end_row();

  const std::string& table() const { return table_; }

 private:
  void separate();

  std::string table_;
  bool row_has_fields_ = false;
};

}  // namespace sturm
