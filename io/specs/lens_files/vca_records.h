#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/specs/prescription_notation.h"

namespace sturm {

/// Heights of one surface on a rectangular grid, as a record SURFMT and its records ZZ have them.
struct VcaMatrix {
  std::optional<EyeSide> eye;
  bool front = false;
  int line = 0, columns = 0, rows = 0;
  double width_mm = 0.0, height_mm = 0.0;
  std::vector<std::optional<double>> heights_mm;  ///< row by row; none where the file knows none
};

/// The records of a file of the Data Communication Standard, LABEL=value, by label in capitals.
class VcaRecords {
 public:
  /// Line ends, control characters between records and the case of labels do not matter. Throws InputError for a text
  /// without records, and for a matrix that is not whole.
  VcaRecords(std::string_view text, const std::string& file);

  bool has(const std::string& label) const { return records_.contains(label); }

  /// The text for an eye: "right;left", or one value for both. None where it is not there, empty or "?".
  std::optional<std::string> text(const std::string& label, EyeSide eye) const;

  /// The same as a number. Throws InputError for anything else.
  std::optional<double> number(const std::string& label, EyeSide eye) const;

  /// The eyes that the job has values for: from DO, else from where values stand.
  std::vector<EyeSide> eyes() const;

  const VcaMatrix* matrix(bool front, EyeSide eye) const;

  const std::vector<std::string>& repeated() const { return repeated_; }  ///< labels; their last record counts

  /// Labels that stand in the file and are none of `known`.
  std::vector<std::string> others(const std::vector<std::string_view>& known) const;

  /// Throws InputError about the line of a record.
  [[noreturn]] void fail(const std::string& label, const std::string& got, const std::string& expected) const;

 private:
  struct Record {
    std::string value;
    int line;
  };

  void add_matrix(std::string_view value, int line);
  void add_row(std::string_view value, int line);
  [[noreturn]] void fail_at(int line, const std::string& got, const std::string& expected) const;

  std::string file_;
  std::map<std::string, Record> records_;
  std::vector<std::string> repeated_;
  std::vector<VcaMatrix> matrices_;
};

}  // namespace sturm
