#include "wavefront/fitting/virtual_eyes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>

namespace sturm {

namespace {

EyeStatistics statistics_from(double pupil_mm, const nlohmann::json& entry) {
  const auto mean = entry.at("mean_um").get<std::vector<double>>();
  const auto size = static_cast<Eigen::Index>(mean.size());
  EyeStatistics statistics{pupil_mm, entry.at("n_eyes").get<int>(),
                           Eigen::Map<const Eigen::VectorXd>(mean.data(), size), Eigen::MatrixXd(size, size)};
  const nlohmann::json& lower = entry.at("cov_um2_rowmajor_lower");
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index k = 0; k <= i; ++k)
      statistics.covariance(i, k) = statistics.covariance(k, i) =
          lower.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(k)).get<double>();
  return statistics;
}

}  // namespace

const std::vector<EyeStatistics>& thibos_eyes() {
  static const std::vector<EyeStatistics> populations = [] {
    std::vector<EyeStatistics> read;
    const auto document = nlohmann::json::parse(embedded_eye_statistics().front().second);
    for (const auto& [pupil, entry] : document.at("pupils").items())
      read.push_back(statistics_from(std::stod(pupil), entry));
    std::sort(read.begin(), read.end(),
              [](const EyeStatistics& a, const EyeStatistics& b) { return a.pupil_diameter_mm < b.pupil_diameter_mm; });
    return read;
  }();
  return populations;
}

Eigen::VectorXd draw_eye(const EyeStatistics& statistics, std::uint64_t seed) {
  // Rounded covariances may have eigenvalues a little below 0; such directions do not scatter.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(statistics.covariance);
  std::mt19937_64 bits(seed);
  const auto uniform = [&] { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53; };
  Eigen::VectorXd scattered(statistics.mean.size());
  for (Eigen::Index i = 0; i < scattered.size(); ++i) {  // Box and Muller
    const double length = std::sqrt(-2.0 * std::log(uniform())), angle = 2.0 * std::numbers::pi * uniform();
    scattered[i] = length * std::cos(angle) * std::sqrt(std::max(0.0, axes.eigenvalues()[i]));
  }
  return statistics.mean + axes.eigenvectors() * scattered;
}

}  // namespace sturm
