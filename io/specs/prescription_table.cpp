#include "io/specs/prescription_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "io/files/csv_table.h"
#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "io/files/readable_text.h"
#include "io/files/text_encoding.h"
#include "io/files/text_file.h"
#include "io/specs/notation_tokens.h"
#include "io/specs/prescription_notation.h"
#include "lensmodel/power_matrix.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

const CsvColumn id_column{"id", {"patient", "patientid", "subject", "subjectid", "name", "nr", "no", "number", "case"}};
const CsvColumn eye_column{"eye", {"side", "laterality", "odos", "auge"}};
const CsvColumn sphere_column{"sph_D", {"sph", "sphere", "sphered", "s", "sphdpt", "spheredpt", "sf"}};
const CsvColumn cylinder_column{
    "cyl_D", {"cyl", "cylinder", "cylinderd", "c", "zyl", "zylinder", "cyldpt", "cylinderdpt", "zyldpt"}};
const CsvColumn axis_column{"axis_deg", {"axis", "ax", "a", "achse", "axe", "axisdegrees", "axisdegree"}};
const CsvColumn notation_column{"rx",
                                {"prescription", "refraction", "notation", "spectaclerx", "spectacleprescription"}};
const CsvColumn vertex_column{"vertex_distance_mm",
                              {"vertexdistance", "vdmm", "vd", "bvd", "bvdmm", "vertexmm", "hsa", "hsamm"}};

const CsvColumn age_column{"age", {"ageyears", "years", "alter", "edad"}};
const CsvColumn addition_column{"add_D", {"add", "addition", "additiond", "nearaddition", "zusatz"}};

/// Words for "none" in cells of cylinder and axis, and the sphere's unit, which opticians write there.
constexpr std::array<std::string_view, 6> nothings{"-", "--", "---", "/", "ds", "sph"};

/// A table and the row of it that is read.
class Rows {
 public:
  Rows(std::string contents, const std::string& file) : table_(std::move(contents), file) {
    id_ = table_.find(id_column), eye_ = table_.find(eye_column);
    sphere_ = table_.find(sphere_column), cylinder_ = table_.find(cylinder_column), axis_ = table_.find(axis_column);
    notation_ = table_.find(notation_column), vertex_ = table_.find(vertex_column);
    age_ = table_.find(age_column), addition_ = table_.find(addition_column);
    if (!id_) fail_at_heading("a column id (or patient, subject, name, number)");
    if (notation_ && (sphere_ || cylinder_ || axis_))
      fail_at_heading("a column rx, or columns sph_D, cyl_D and axis_deg");
    if (notation_) return;
    if (!sphere_) fail_at_heading("a column sph_D, or a column rx");
    if (!cylinder_) fail_at_heading("a column cyl_D");
    if (!axis_) fail_at_heading("a column axis_deg");
  }

  bool next() {
    std::optional<CsvRow> row = table_.next();
    if (row) row_ = std::move(*row);
    return row.has_value();
  }

  std::vector<TabledPrescription> prescriptions(double vertex_distance_m) const {
    if (notation_) return noted(vertex_distance_m);
    Prescription rx;
    rx.sphere_D = dioptres(text(*sphere_, sphere_column), sphere_column);
    const std::string& cylinder = field(*cylinder_, cylinder_column);
    rx.cylinder_D = is_nothing(cylinder) ? 0.0 : dioptres(cylinder, cylinder_column);
    const std::string& axis = field(*axis_, axis_column);
    if (!is_nothing(axis))
      rx.axis_deg = degrees(axis);
    else if (rx.cylinder_D != 0.0)
      fail(axis.empty() ? "" : axis, "a value in column axis_deg, which a cylinder needs");
    return {{named(eye_ ? text(*eye_, eye_column) : ""), valid(rx, vertex_distance_m), age(), addition()}};
  }

 private:
  static bool is_nothing(const std::string& cell) {
    return cell.empty() || std::ranges::find(nothings, lower_case(cell)) != nothings.end();
  }

  const std::string& field(std::size_t index, const CsvColumn& column) const {
    if (index >= row_.fields.size()) fail("", "a value in column " + column.name + ", or a field that is left empty");
    return row_.fields[index];
  }

  const std::string& text(std::size_t index, const CsvColumn& column) const {
    const std::string& value = field(index, column);
    if (value.empty()) fail("", "a value in column " + column.name);
    return value;
  }

  double number(const std::string& cell, const CsvColumn& column) const {
    const std::optional<double> value = csv_number(cell);
    if (!value) fail(readable(cell, 80), "a number in column " + column.name);
    return *value;
  }

  /// "+1.25", "1,25", "PL", "-2.00 D", "-2.00 DS".
  double dioptres(std::string cell, const CsvColumn& column) const {
    if (is_plano(lower_case(cell))) return 0.0;
    for (const std::string_view unit : {"DS", "DC", "D", "dpt"})
      if (cell.ends_with(unit)) {
        cell.erase(cell.size() - unit.size());
        cell.erase(cell.find_last_not_of(' ') + 1);
        break;
      }
    if (may_lack_its_point(with_keyboard_signs(cell)))
      fail(readable(cell, 80), "a number with a point in column " + column.name +
                                   ", since this could be hundredths (numbers with a decimal comma need quotes, or "
                                   "semicolons between fields)");
    return number(cell, column);
  }

  /// "30", "30°", "x 30".
  double degrees(std::string cell) const {
    for (const std::string_view sign : {"°", "deg", "º"})
      if (cell.ends_with(sign)) cell.erase(cell.size() - sign.size());
    for (const std::string_view sign : {"x", "X", "×"})
      if (cell.starts_with(sign)) cell.erase(0, sign.size());
    cell.erase(0, std::min(cell.find_first_not_of(' '), cell.size()));
    cell.erase(cell.find_last_not_of(' ') + 1);
    if (with_keyboard_signs(cell).starts_with('-'))
      fail(readable(cell, 80), "an axis from 0 to 180 in column " + axis_column.name);
    return number(cell, axis_column);
  }

  /// A cell that may be empty, or that the table may not have at all.
  const std::string* stated(const std::optional<std::size_t>& index) const {
    if (!index || *index >= row_.fields.size() || is_nothing(row_.fields[*index])) return nullptr;
    return &row_.fields[*index];
  }

  std::optional<double> age() const {
    constexpr double oldest = 150.0;
    const std::string* cell = stated(age_);
    if (!cell) return std::nullopt;
    const double years = number(*cell, age_column);
    if (!(years >= 0.0 && years <= oldest)) fail(readable(*cell, 80), "an age from 0 to 150 in column age");
    return years;
  }

  std::optional<double> addition() const {
    constexpr double largest_D = 10.0;
    const std::string* cell = stated(addition_);
    if (!cell) return std::nullopt;
    const double power_D = dioptres(*cell, addition_column);
    if (!(power_D >= 0.0 && power_D <= largest_D))
      fail(readable(*cell, 80), "an addition from 0 to 10 D in column add_D");
    return power_D;
  }

  Prescription valid(Prescription rx, double vertex_distance_m) const {
    rx.vertex_distance_m = vertex_distance_m;
    if (const std::string* cell = stated(vertex_))
      rx.vertex_distance_m = metres_per_millimetre * number(*cell, vertex_column);
    try {
      validate(rx);
      power_at_cornea(rx);
    } catch (const std::logic_error& error) {  // std::invalid_argument, std::domain_error
      fail(readable(row_.text, 80), std::string("a prescription that can be computed: ") + error.what());
    }
    return rx;
  }

  /// A row with a text: of the eye in its column, or of each eye that the text names.
  std::vector<TabledPrescription> noted(double vertex_distance_m) const {
    const Source line{table_.file(), "line " + std::to_string(row_.line)};
    const std::string& notation = text(*notation_, notation_column);
    std::vector<NotedPrescription> eyes;
    if (eye_)
      eyes = {read_notation(notation, line, eye_side(text(*eye_, eye_column)))};
    else if (const auto both = eyes_of(notation); both.size() == 2)
      eyes = both;
    else
      eyes = {read_notation(notation, line)};
    std::vector<TabledPrescription> result;
    for (const NotedPrescription& rx : eyes) {
      if (rx.has_prism()) fail(readable(notation, 80), "no prism: it has no part in the blur of an eye");
      const std::string eye = eye_ ? text(*eye_, eye_column) : !rx.eye ? "" : *rx.eye == EyeSide::right ? "OD" : "OS";
      const double distance_m =
          rx.vertex_distance_mm ? metres_per_millimetre * *rx.vertex_distance_mm : vertex_distance_m;
      result.push_back({named(eye), valid({rx.sphere_D, rx.cylinder_D, rx.axis_deg.value_or(180.0)}, distance_m), age(),
                        rx.addition_D ? rx.addition_D : addition()});
    }
    return result;
  }

  /// "P172-OS"; without an eye the id alone.
  std::string named(const std::string& eye) const {
    const std::string& id = text(*id_, id_column);
    return eye.empty() ? id : id + "-" + eye;
  }

  static std::vector<NotedPrescription> eyes_of(const std::string& notation) {
    try {
      return parse_prescription_notation(notation);
    } catch (const std::invalid_argument&) {
      return {};  // read_notation says what is wrong
    }
  }

  [[noreturn]] void fail(const std::string& value, const std::string& expected) const {
    table_.fail(row_.line, value, expected);
  }

  [[noreturn]] void fail_at_heading(const std::string& expected) const {
    table_.fail(table_.heading().line, "the columns " + readable(table_.heading().text, 80), expected);
  }

  CsvTable table_;
  std::optional<std::size_t> id_, eye_, sphere_, cylinder_, axis_, notation_, vertex_, age_, addition_;
  CsvRow row_;
};

}  // namespace

std::vector<TabledPrescription> read_prescription_table(const std::filesystem::path& file, double vertex_distance_m) {
  auto contents = file_contents(file);
  if (!contents) throw InputError(file.string(), "", "", "a file that can be read");
  Rows rows(std::move(*contents), file.string());
  std::vector<TabledPrescription> eyes;
  while (rows.next())
    for (TabledPrescription& eye : rows.prescriptions(vertex_distance_m)) eyes.push_back(std::move(eye));
  if (eyes.empty()) throw InputError(file.string(), "", "", "a table with at least one prescription");
  return eyes;
}

}  // namespace sturm
