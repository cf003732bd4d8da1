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

/// One row of a table that was read.
struct CsvRow {
  int line = 0;           ///< the number, from 1, of the line that it starts on
  std::string_view text;  ///< the row as it stands in the table, without its line end
  std::vector<std::string> fields;
};

/// Reads a table row by row (RFC 4180). Rows end with CRLF or LF; a byte order mark before the first one is skipped.
/// Blank lines and lines that start with # are no rows, and blanks (spaces, tabs) around a field are not part of it
/// unless they stand in its quotes.
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
  bool at_end_of_field() const;
  [[noreturn]] void fail(int line, std::string_view value, const std::string& expected) const;

  std::string_view text_;
  std::string file_;
  CsvDialect dialect_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// The number that a field consists of ("1.5", "-2e-3", "inf", "nan"); none where it holds anything else.
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
