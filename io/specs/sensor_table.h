#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <vector>

#include "lensmodel/words.h"

namespace sturm {

/// The frame in which a table of a wavefront sensor counts x and y.
enum class TableFrame {
  Examiner,  ///< x right, y up for a person who faces the wearer
  Wearer,    ///< x right, y up as the wearer sees it
  Image      ///< x right, y down for a person who faces the wearer: pixels of a camera picture
};

inline constexpr Words<TableFrame, 3> table_frame_words{
    {{TableFrame::Examiner, "examiner"}, {TableFrame::Wearer, "wearer"}, {TableFrame::Image, "image"}}};

/// What a table does not say itself.
struct SensorTableOptions {
  std::optional<double> pixel_m;          ///< side of a pixel, for columns in px
  std::optional<double> focal_length_m;   ///< of the lenslets, for pairs of spots
  std::optional<double> grid_step_m;      ///< between the heights of a plain matrix
  std::optional<double> wavelength_nm;    ///< for heights in waves
  std::optional<Eigen::Vector2d> centre;  ///< of the pupil, in the table's own unit and frame
  std::optional<TableFrame> frame;        ///< none: that of an image for px, else the examiner's
  bool negative_slopes = false;           ///< slopes are −∇W
};

/// One row of a sensor's table in the examiner's frame about the pupil's centre.
struct SensorPoint {
  Eigen::Vector2d point;                            ///< [m]
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< +∇W [rad]
  double height = 0.0;                              ///< W [m]
  int line;                                         ///< in the file
};

struct SensorTable {
  bool heights = false;  ///< of the wavefront; otherwise slopes
  std::vector<SensorPoint> points;
  std::vector<SensorPoint> missing;  ///< rows with a place, but without a spot or height
  Eigen::Vector2d centre;            ///< that was used, in the table's own unit and frame
};

/// Reads a CSV table by the names of its columns, which carry their units (docs/commands/wavefront.md): slopes
/// (x_mm, y_mm, slope_x_rad, slope_y_rad), pairs of spots (ref_x_px, ref_y_px, meas_x_px, meas_y_px) or heights (x_mm,
/// y_mm, opd_um); or a plain matrix of heights [µm] whose first row is the highest. Empty and NaN measurements are
/// missing. Throws InputError with file and line.
SensorTable read_sensor_table(const std::filesystem::path& file, const SensorTableOptions& options);

}  // namespace sturm
