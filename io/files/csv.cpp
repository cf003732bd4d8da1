#include "io/files/csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "io/files/error.h"
#include "io/files/text_encoding.h"

namespace sturm {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t";
constexpr std::string_view line_ends = "\r\n";

bool is_note_or_blank(std::string_view line) {
  const std::size_t first = line.find_first_not_of(blanks);
  return first == std::string_view::npos || line[first] == '#';
}

/// A line that only says what the separator is; spreadsheets write it before the heading.
bool names_separator(std::string_view line) {
  const std::size_t last = line.find_last_not_of(' ');
  return line.starts_with("sep=") && (last == 4 || line == "sep=\t");
}

}  // namespace

CsvDialect csv_dialect_of(std::string_view text) {
  CsvDialect dialect;
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of(line_ends));
    if (names_separator(line)) return {line[4], dialect.quote};
    if (!is_note_or_blank(line)) break;
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  bool quoted = false, comma = false, tab = false, blank = false;
  for (const char c : text) {
    if (c == dialect.quote) quoted = !quoted;
    if (quoted) continue;
    if (line_ends.find(c) != std::string_view::npos) break;
    if (c == ';') return {';', dialect.quote};
    comma |= c == ',', tab |= c == '\t', blank |= c == ' ';
  }
  dialect.separator = tab ? '\t' : comma || !blank ? ',' : ' ';
  return dialect;
}

CsvReader::CsvReader(std::string_view text, std::string file, CsvDialect dialect)
    : text_(text), file_(std::move(file)), dialect_(dialect) {
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

std::optional<CsvRow> CsvReader::next() {
  while (at_ < text_.size()) {
    const std::size_t start = at_, end = std::min(text_.find_first_of(line_ends, at_), text_.size());
    const std::string_view line = text_.substr(start, end - start);
    std::optional<CsvRow> row;
    if (is_note_or_blank(line) || (start == 0 && names_separator(line))) {
      at_ = end;
    } else {
      row.emplace().line = line_;
      row->fields.push_back(field());
      while (at_ < text_.size() && at_separator()) {
        ++at_;
        if (dialect_.separator == ' ' && (skip_blanks(), at_end_of_field())) break;
        row->fields.push_back(field());
      }
      row->text = text_.substr(start, at_ - start);
    }
    skip_line_end();
    if (row) return row;
  }
  return std::nullopt;
}

/// CRLF is one line end.
void CsvReader::skip_line_end() {
  if (at_ == text_.size()) return;
  at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
  ++line_;
}

std::string CsvReader::field() {
  skip_blanks();
  if (at_ < text_.size() && text_[at_] == dialect_.quote) return quoted_field();
  const std::size_t start = at_;
  while (!at_end_of_field()) ++at_;
  std::string_view field = text_.substr(start, at_ - start);
  field.remove_suffix(field.size() - (field.find_last_not_of(blanks) + 1));
  return std::string(field);
}

std::string CsvReader::quoted_field() {
  const std::size_t start = at_;
  const int first_line = line_;
  std::string field;
  for (++at_; at_ < text_.size(); ++at_) {
    if (text_[at_] == dialect_.quote) {
      ++at_;
      if (at_ == text_.size() || text_[at_] != dialect_.quote) {
        skip_blanks();
        if (!at_end_of_field()) fail(line_, text_.substr(at_), "the end of the field after its closing quote");
        return field;
      }
    }
    if (text_[at_] == '\n' || (text_[at_] == '\r' && !text_.substr(at_).starts_with("\r\n"))) ++line_;
    field += text_[at_];
  }
  fail(first_line, text_.substr(start), "a closing quote");
}

void CsvReader::skip_blanks() {
  const auto cuts = [&] { return dialect_.separator != ' ' && at_separator(); };
  while (at_ < text_.size() && !cuts() && blanks.find(text_[at_]) != std::string_view::npos) ++at_;
}

bool CsvReader::at_separator() const {
  return text_[at_] == dialect_.separator || (dialect_.separator == ' ' && text_[at_] == '\t');
}

bool CsvReader::at_end_of_field() const {
  return at_ == text_.size() || at_separator() || line_ends.find(text_[at_]) != std::string_view::npos;
}

void CsvReader::fail(int line, std::string_view value, const std::string& expected) const {
  constexpr std::size_t shown = 40;
  const std::string_view first_line = value.substr(0, value.find_first_of(line_ends));
  throw InputError(file_, "line " + std::to_string(line), shortened(first_line, shown), expected);
}

std::optional<double> csv_number(std::string_view field) {
  std::string text = with_keyboard_signs(field);
  if (text.starts_with('+') && text.find_first_of("+-", 1) != 1) text.erase(0, 1);
  if (text.find('.') == std::string::npos)
    if (const auto comma = text.find(','); comma != std::string::npos) text[comma] = '.';
  double value = 0.0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc{} && end == last ? std::optional(value) : std::nullopt;
}

void CsvWriter::text(std::string_view value) {
  separate();
  if (value.find_first_of(",\"\r\n") == std::string_view::npos) {
    table_ += value;
    return;
  }
  table_ += '"';
  for (const char c : value) table_.append(c == '"' ? 2 : 1, c);
  table_ += '"';
}

void CsvWriter::number(std::optional<double> value) {
  separate();
  std::array<char, 32> text;
  if (value) table_.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), *value).ptr);
}

void CsvWriter::number(std::optional<double> value, int digits) {
  separate();
  std::array<char, 32> text;
  if (value)
    table_.append(
        text.data(),
        std::to_chars(text.data(), text.data() + text.size(), *value, std::chars_format::general, digits).ptr);
}

void CsvWriter::empty(std::size_t fields) {
  for (; fields > 0; --fields) separate();
}

void CsvWriter::end_row() {
  table_ += "\r\n";
  row_has_fields_ = false;
}

void CsvWriter::separate() {
  if (std::exchange(row_has_fields_, true)) table_ += ',';
}

}  // namespace sturm
