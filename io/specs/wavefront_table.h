#pragma once
#include <filesystem>
#include <vector>

namespace sturm {

/// Reads a table (io/files/csv_table.h) of measured wavefronts, one eye in each row, of which the columns c0, c1, … are
/// used: OSA/ANSI coefficients, normalised, examiner frame [µm] (configs/data/hofer_9_subjects_6mm.csv). A column that
/// is not there is zero. Rows with a missing coefficient (an empty field or "nan") are left out. Each result has a
/// coefficient for every number up to the table's last column. Throws InputError with file and line.
std::vector<std::vector<double>> read_wavefront_table(const std::filesystem::path& file);

}  // namespace sturm
