#include "io/files/csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "io/files/error.h"

namespace sturm {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t\r";  // a carriage return belongs to the line end

}  // namespace

CsvReader::CsvReader(std::string_view text, std::string file, CsvDialect dialect)
    : text_(text), file_(std::move(file)), dialect_(dialect) {
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

std::optional<CsvRow> CsvReader::next() {
  while (at_ < text_.size()) {
    const std::size_t start = at_, end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(start, end - start);
    std::optional<CsvRow> row;
    if (line.starts_with('#') || line.find_first_not_of(blanks) == std::string_view::npos) {
      at_ = end;
    } else {
      row.emplace().line = line_;
      row->fields.push_back(field());
      while (at_ < text_.size() && text_[at_] == dialect_.separator) {
        ++at_;
        row->fields.push_back(field());
      }
      row->text = text_.substr(start, at_ - start);
      if (row->text.ends_with('\r')) row->text.remove_suffix(1);
    }
    if (at_ < text_.size()) ++at_, ++line_;
    if (row) return row;
  }
  return std::nullopt;
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
    if (text_[at_] == '\n') ++line_;
    field += text_[at_];
  }
  fail(first_line, text_.substr(start), "a closing quote");
}

void CsvReader::skip_blanks() {
  while (at_ < text_.size() && !at_end_of_field() && blanks.find(text_[at_]) != std::string_view::npos) ++at_;
}

bool CsvReader::at_end_of_field() const {
  return at_ == text_.size() || text_[at_] == dialect_.separator || text_[at_] == '\n';
}

void CsvReader::fail(int line, std::string_view value, const std::string& expected) const {
  constexpr std::size_t shown = 40;
  const std::string_view first_line = value.substr(0, value.find_first_of("\r\n"));
  throw InputError(file_, "line " + std::to_string(line), std::string(first_line.substr(0, shown)), expected);
}

std::optional<double> csv_number(std::string_view field) {
  double value = 0.0;
  const char* last = field.data() + field.size();
  const auto [end, error] = std::from_chars(field.data(), last, value);
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
