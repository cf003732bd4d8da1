#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace sturm {

/// Mean and covariance of the Zernike coefficients of a population of eyes over one pupil [µm, µm²], OSA normalised
/// from j = 0 on, in the convention of left eyes.
struct EyeStatistics {
  double pupil_diameter_mm;
  int eyes;  ///< that were measured
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

/// File names and texts of the statistics that are compiled in (configs/data).
const std::vector<std::pair<std::string_view, std::string_view>>& embedded_eye_statistics();

/// [Thibos2002]: healthy young eyes at 3, 4.5, 6 and 7.5 mm, by rising pupil.
const std::vector<EyeStatistics>& thibos_eyes();

/// Coefficients [µm] of a random eye of the population: normal with its mean and covariance; one seed, one eye.
Eigen::VectorXd draw_eye(const EyeStatistics& statistics, std::uint64_t seed);

}  // namespace sturm
