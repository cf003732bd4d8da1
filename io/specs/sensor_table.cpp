#include "io/specs/sensor_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "io/files/csv.h"
#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "io/files/text_encoding.h"
#include "io/files/text_file.h"
#include "lensmodel/chromatic_eye.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

struct Unit {
  const char* suffix;
  double factor;  ///< to metres or radians; 0: by an option
};

constexpr Unit lengths[] = {{"_mm", 1e-3}, {"_um", 1e-6}, {"_m", 1.0}, {"_px", 0.0}};
constexpr Unit angles[] = {{"_rad", 1.0},
                           {"_mrad", 1e-3},
                           {"_urad", 1e-6},
                           {"_arcmin", 1.0 / arcminutes_per_radian},
                           {"_arcsec", 1.0 / (60.0 * arcminutes_per_radian)},
                           {"_deg", radians_per_degree}};
constexpr Unit heights[] = {{"_um", 1e-6}, {"_nm", 1e-9}, {"_mm", 1e-3}, {"_m", 1.0}, {"_waves", 0.0}};

/// A quantity with an x and a y column, or one column alone.
struct Column {
  int x = -1, y = -1;
  double factor = 1.0;
  bool by_option = false;

  explicit operator bool() const { return x >= 0; }
};

class Heading {
 public:
  explicit Heading(std::vector<std::string> names) : names_(std::move(names)) {
    for (std::string& name : names_) name = lower_case(name);
  }

  int index(const std::string& name) const {
    const auto at = std::find(names_.begin(), names_.end(), name);
    return at == names_.end() ? -1 : static_cast<int>(at - names_.begin());
  }

  /// The first unit for which both columns are there.
  template <std::size_t count>
  Column pair(const std::string& name, const Unit (&units)[count]) const {
    for (const Unit& unit : units) {
      const Column c{index(name + "x" + unit.suffix), index(name + "y" + unit.suffix), unit.factor, unit.factor == 0.0};
      if (c.x >= 0 && c.y >= 0) return c;
    }
    return {};
  }

  template <std::size_t count>
  Column single(const std::string& name, const Unit (&units)[count]) const {
    for (const Unit& unit : units)
      if (const int at = index(name + unit.suffix); at >= 0) return {at, at, unit.factor, unit.factor == 0.0};
    return {};
  }

 private:
  std::vector<std::string> names_;
};

/// What the columns of a table are.
struct Layout {
  Column place, slope, measured, height;
  double place_factor = 1.0;  ///< from the table's unit to metres
};

class Reader {
 public:
  Reader(std::string file, const SensorTableOptions& options) : file_(std::move(file)), options_(options) {}

  SensorTable read(std::string_view text) {
    CsvReader rows(text, file_, csv_dialect_of(text));
    std::optional<CsvRow> first = rows.next();
    if (!first) throw InputError(file_, "", "an empty table", "a table of slopes, pairs of spots or heights");
    if (csv_number(first->fields[0]) || first->fields[0].empty())
      read_matrix(rows, std::move(*first));
    else
      read_columns(rows, std::move(*first));
    if (table_.points.empty()) throw InputError(file_, "", "a table without a measurement", "at least one");
    place();
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& value, const std::string& expected) const {
    throw InputError(file_, "line " + std::to_string(line), value, expected);
  }

  [[noreturn]] void needs(const char* option, const std::string& what) const {
    throw InputError("", option, "nothing", what + ", which " + file_ + " needs");
  }

  /// A number; NaN for an empty field.
  double number(const CsvRow& row, int column) const {
    if (column >= static_cast<int>(row.fields.size()) || row.fields[static_cast<std::size_t>(column)].empty())
      return no_number;
    const std::string& field = row.fields[static_cast<std::size_t>(column)];
    const std::optional<double> value = csv_number(field);
    if (!value || std::isinf(*value)) fail(row.line, "\"" + field + "\"", "a number");
    return *value;
  }

  double pixel() const {
    if (!options_.pixel_m) needs("--pixel-um", "the side of a pixel [um] for columns in px");
    return *options_.pixel_m;
  }

  double height_factor(const Column& c) const {
    if (!c.by_option) return c.factor;
    if (!options_.wavelength_nm) needs("--wavelength-nm", "the wavelength [nm] for heights in waves");
    return metres_per_nanometre * *options_.wavelength_nm;
  }

  Layout layout(const Heading& heading, int line) const {
    Layout found;
    found.place = heading.pair("ref_", lengths);
    if (!found.place) found.place = heading.pair("", lengths);
    found.slope = heading.pair("slope_", angles);
    found.measured = heading.pair("meas_", lengths);
    found.height = heading.single("opd", heights);
    if (!found.height) found.height = heading.single("w", heights);
    if (found.measured && found.slope) (options_.focal_length_m ? found.slope : found.measured) = Column{};
    if (!found.place || !(found.slope || found.measured || found.height))
      fail(line, "its columns",
           "x_mm, y_mm, slope_x_rad, slope_y_rad (slopes); ref_x_px, ref_y_px, meas_x_px, meas_y_px (pairs of spots); "
           "or x_mm, y_mm, opd_um (heights)");
    if (found.measured && !options_.focal_length_m)
      needs("--focal-length-mm", "the focal length of the lenslets [mm] for pairs of spots");
    found.place_factor = found.place.by_option ? pixel() : found.place.factor;
    return found;
  }

  void read_columns(CsvReader& rows, CsvRow heading) {
    const Layout columns = layout(Heading(std::move(heading.fields)), heading.line);
    factor_ = columns.place_factor;
    in_pixels_ = columns.place.by_option;
    table_.heights = static_cast<bool>(columns.height) && !columns.slope && !columns.measured;
    const double height_scale = table_.heights ? height_factor(columns.height) : 1.0;
    const double measured_scale = columns.measured.by_option ? pixel() : columns.measured.factor;
    while (const std::optional<CsvRow> row = rows.next()) {
      SensorPoint point{{number(*row, columns.place.x), number(*row, columns.place.y)}, {0, 0}, 0.0, row->line};
      if (!point.point.allFinite()) fail(row->line, std::string(row->text), "a place of the lenslet");
      if (table_.heights)
        point.height = height_scale * number(*row, columns.height.x);
      else if (columns.slope)
        point.slope =
            columns.slope.factor * Eigen::Vector2d(number(*row, columns.slope.x), number(*row, columns.slope.y));
      else
        point.slope =
            (measured_scale * Eigen::Vector2d(number(*row, columns.measured.x), number(*row, columns.measured.y)) -
             factor_ * point.point) /
            *options_.focal_length_m;
      add(point);
    }
  }

  void read_matrix(CsvReader& rows, CsvRow first) {
    if (!options_.grid_step_m)
      needs("--grid-step-mm", "the distance between the heights of a matrix [mm], or a heading that names the columns");
    table_.heights = true;
    factor_ = *options_.grid_step_m;
    const std::size_t width = first.fields.size();
    int height = 0;
    for (std::optional<CsvRow> row = std::move(first); row; row = rows.next(), ++height) {
      if (row->fields.size() != width)
        fail(row->line, std::to_string(row->fields.size()) + " fields", std::to_string(width) + " as in the first row");
      for (std::size_t column = 0; column < width; ++column)
        add({{static_cast<double>(column), static_cast<double>(-height)},
             {0, 0},
             metres_per_micrometre * number(*row, static_cast<int>(column)),
             row->line});
    }
    matrix_centre_ = {0.5 * (static_cast<double>(width) - 1.0), -0.5 * (height - 1.0)};
  }

  void add(const SensorPoint& point) {
    const bool there = table_.heights ? std::isfinite(point.height) : point.slope.allFinite();
    (there ? table_.points : table_.missing).push_back(point);
  }

  /// From the table's unit and frame to metres in the examiner's frame about the pupil's centre.
  void place() {
    table_.centre = options_.centre.value_or(matrix_centre_.value_or(Eigen::Vector2d::Zero()));
    if (!options_.centre && in_pixels_) {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (const auto* list : {&table_.points, &table_.missing})
        for (const SensorPoint& p : *list) sum += p.point;
      table_.centre = sum / static_cast<double>(table_.points.size() + table_.missing.size());
    }
    const TableFrame frame = options_.frame.value_or(in_pixels_ ? TableFrame::Image : TableFrame::Examiner);
    const Eigen::Vector2d turn(frame == TableFrame::Wearer ? -1.0 : 1.0, frame == TableFrame::Image ? -1.0 : 1.0);
    for (auto* list : {&table_.points, &table_.missing})
      for (SensorPoint& p : *list) {
        p.point = factor_ * turn.cwiseProduct(p.point - table_.centre);
        p.slope = (options_.negative_slopes ? -1.0 : 1.0) * turn.cwiseProduct(p.slope);
      }
  }

  std::string file_;
  const SensorTableOptions& options_;
  SensorTable table_;
  double factor_ = 1.0;
  bool in_pixels_ = false;
  std::optional<Eigen::Vector2d> matrix_centre_;
};

}  // namespace

SensorTable read_sensor_table(const std::filesystem::path& file, const SensorTableOptions& options) {
  const auto contents = file_contents(file);
  if (!contents) throw InputError(file.string(), "", "", "a file that can be read");
  return Reader(file.string(), options).read(utf8_text(*contents));
}

}  // namespace sturm
