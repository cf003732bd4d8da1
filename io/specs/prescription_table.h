#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lensmodel/prescription.h"

namespace sturm {

/// One eye of a table of prescriptions.
struct TabledPrescription {
  std::string id;                               ///< "P172-OS": id and eye; the id alone where the table has no eyes
  Prescription prescription;                    ///< as written, at the vertex distance of its row or of all
  std::optional<double> age_years, addition_D;  ///< where the table states them
};

/// Reads a table (io/files/csv_table.h) of which the columns id, eye (may be missing), sph_D, cyl_D, axis_deg and
/// vertex_distance_mm are used (configs/data/papila_prescriptions.csv), or rx in optical notation
/// (io/specs/prescription_notation.h) in place of the numbers; age and add where they are there. Names that opticians
/// give to these columns are known. A sphere may leave cylinder and axis empty. Rows that state no vertex distance get
/// `vertex_distance_m`. Throws InputError with file and line.
std::vector<TabledPrescription> read_prescription_table(const std::filesystem::path& file, double vertex_distance_m);

}  // namespace sturm
