#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "lensmodel/prescription.h"

namespace sturm {

/// One eye of a table of prescriptions.
struct TabledPrescription {
  std::string id;  ///< "P172-OS": id and eye
  Prescription prescription;
};

/// Reads a table with comma-separated columns of which eye, id, sph_D, cyl_D and axis_deg are used
/// (configs/data/papila_prescriptions.csv); lines that start with # are skipped. The table states no vertex distance:
/// all get `vertex_distance_m`. Throws InputError.
std::vector<TabledPrescription> read_prescription_table(const std::filesystem::path& file, double vertex_distance_m);

}  // namespace sturm
