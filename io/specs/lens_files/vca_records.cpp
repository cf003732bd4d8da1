#include "io/specs/lens_files/vca_records.h"

#include <algorithm>
#include <cmath>

#include "io/files/csv.h"
#include "io/files/error.h"
#include "io/files/readable_text.h"

namespace sturm {

namespace {

constexpr int most_nodes = 2048;  // each way
constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> parts_of(std::string_view value) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = value.find(';');
    parts.push_back(trimmed(value.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    value.remove_prefix(end + 1);
  }
}

bool is_unknown(std::string_view value) {
  return value.empty() || value.find_first_not_of('?') == std::string_view::npos;
}

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return capitals;
}

}  // namespace

VcaRecords::VcaRecords(std::string_view text, const std::string& file) : file_(file) {
  int line = 0;
  while (!text.empty()) {
    // Records end with CRLF; in transmissions other control characters stand about them.
    const auto end = static_cast<std::size_t>(
        std::ranges::find_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; }) -
        text.begin());
    ++line;
    const std::string_view record = trimmed(text.substr(0, end));
    const bool pair = text.substr(end).starts_with("\r\n");
    const std::size_t equals = record.find('=');
    if (equals != std::string_view::npos) {
      const std::string label = in_capitals(trimmed(record.substr(0, equals)));
      const std::string_view value = trimmed(record.substr(equals + 1));
      if (label == "SURFMT") {
        add_matrix(value, line);
      } else if (label == "ZZ") {
        add_row(value, line);
      } else {
        const auto before = records_.find(label);
        if (label == "JOB" && before != records_.end() && before->second.value != value)
          fail_at(line, "a second job, " + readable(value, 40), "one job in a file");
        if (before != records_.end() && std::ranges::find(repeated_, label) == repeated_.end())
          repeated_.push_back(label);
        records_[label] = {std::string(value), line};
      }
    }
    text.remove_prefix(std::min(text.size(), end + (pair ? 2 : 1)));
  }
  if (records_.empty() && matrices_.empty())
    throw InputError(file, "", "no records", "a lens file with records such as SPH=-2.00;-1.75");
  for (const VcaMatrix& matrix : matrices_)
    if (matrix.heights_mm.size() != static_cast<std::size_t>(matrix.columns) * static_cast<std::size_t>(matrix.rows))
      fail_at(matrix.line, "a SURFMT with " + std::to_string(matrix.heights_mm.size()) + " heights",
              std::to_string(matrix.rows) + " records ZZ of " + std::to_string(matrix.columns) + " heights");
}

void VcaRecords::add_matrix(std::string_view value, int line) {
  const auto parts = parts_of(value);
  if (parts.size() < 7)
    fail_at(line, "SURFMT=" + readable(value, 40), "SURFMT=1;SIDE;SURFACE;COLUMNS;ROWS;WIDTH;HEIGHT");
  VcaMatrix matrix;
  matrix.line = line;
  if (parts[0] != "1") fail_at(line, "format " + readable(parts[0], 40), "SURFMT with format 1, heights in records ZZ");
  matrix.eye = eye_side(parts[1]);
  const std::string surface = in_capitals(parts[2]);
  if (surface != "F" && surface != "B") fail_at(line, "surface \"" + readable(surface, 40) + "\"", "F or B");
  matrix.front = surface == "F";
  const auto number = [&](std::size_t index, double least, double most, const char* what) {
    const auto n = csv_number(parts[index]);
    if (!n || !(*n >= least && *n <= most)) fail_at(line, "\"" + readable(parts[index], 40) + "\"", what);
    return *n;
  };
  const auto count = [&](std::size_t index) {
    const double n = number(index, 4.0, most_nodes, "4 to 2048 columns and rows");
    if (n != std::floor(n)) fail_at(line, std::string(parts[index]), "a whole number of columns and rows");
    return static_cast<int>(n);
  };
  matrix.columns = count(3), matrix.rows = count(4);
  matrix.width_mm = number(5, 1.0, 200.0, "a width from 1 to 200 mm");
  matrix.height_mm = number(6, 1.0, 200.0, "a height from 1 to 200 mm");
  matrices_.push_back(std::move(matrix));
}

void VcaRecords::add_row(std::string_view value, int line) {
  if (matrices_.empty()) fail_at(line, "ZZ", "SURFMT before records ZZ");
  VcaMatrix& matrix = matrices_.back();
  std::vector<std::string_view> parts = parts_of(value);
  if (parts.size() == static_cast<std::size_t>(matrix.columns) + 1 && parts.back().empty()) parts.pop_back();
  if (parts.size() != static_cast<std::size_t>(matrix.columns))
    fail_at(line, std::to_string(parts.size()) + " heights", std::to_string(matrix.columns) + ", as SURFMT has it");
  for (const std::string_view part : parts) {
    if (is_unknown(part)) {
      matrix.heights_mm.emplace_back();
      continue;
    }
    const auto height = csv_number(part);
    if (!height || !std::isfinite(*height)) fail_at(line, "\"" + readable(part, 40) + "\"", "a height [mm]");
    matrix.heights_mm.emplace_back(*height);
  }
}

std::optional<std::string> VcaRecords::text(const std::string& label, EyeSide eye) const {
  const auto record = records_.find(label);
  if (record == records_.end()) return std::nullopt;
  const auto parts = parts_of(record->second.value);
  const std::string_view part = parts.size() == 1 ? parts[0] : parts[eye == EyeSide::right ? 0 : 1];
  return is_unknown(part) ? std::nullopt : std::optional(std::string(part));
}

std::optional<double> VcaRecords::number(const std::string& label, EyeSide eye) const {
  const auto value = text(label, eye);
  if (!value) return std::nullopt;
  const auto number = csv_number(*value);
  if (!number || !std::isfinite(*number)) fail(label, label + "=" + readable(*value, 40), "a number");
  return number;
}

std::vector<EyeSide> VcaRecords::eyes() const {
  if (const auto done = records_.find("DO"); done != records_.end()) {
    const std::string eye = in_capitals(parts_of(done->second.value)[0]);
    if (eye == "R") return {EyeSide::right};
    if (eye == "L") return {EyeSide::left};
    if (eye == "B") return {EyeSide::right, EyeSide::left};
  }
  std::vector<EyeSide> eyes;
  for (const EyeSide eye : {EyeSide::right, EyeSide::left}) {
    const bool has_matrix = std::ranges::any_of(matrices_, [&](const VcaMatrix& m) { return m.eye == eye; });
    bool has_value = false;
    for (const char* label : {"SPH", "FRNT", "BACK", "CTHICK"})
      if (const auto record = records_.find(label); record != records_.end())
        has_value |= parts_of(record->second.value).size() > 1 && text(label, eye);
    if (has_matrix || has_value) eyes.push_back(eye);
  }
  return eyes;
}

const VcaMatrix* VcaRecords::matrix(bool front, EyeSide eye) const {
  for (const VcaMatrix& m : matrices_)
    if (m.front == front && (!m.eye || *m.eye == eye)) return &m;
  return nullptr;
}

std::vector<std::string> VcaRecords::others(const std::vector<std::string_view>& known) const {
  std::vector<std::string> labels;
  for (const auto& [label, record] : records_)
    if (std::ranges::find(known, label) == known.end()) labels.push_back(label);
  return labels;
}

void VcaRecords::fail(const std::string& label, const std::string& got, const std::string& expected) const {
  const auto record = records_.find(label);
  if (record != records_.end()) fail_at(record->second.line, got, expected);
  throw InputError(file_, "", got, expected);
}

void VcaRecords::fail_at(int line, const std::string& got, const std::string& expected) const {
  throw InputError(file_, "line " + std::to_string(line), got, expected);
}

}  // namespace sturm
