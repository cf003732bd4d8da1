#include "wavefront/fitting/modal_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lensmodel/gauss_legendre.h"
#include "lensmodel/zernike.h"
#include "wavefront/fitting/least_squares.h"

namespace sturm {

namespace {

constexpr double normal_quartile = 0.6744897501960817;  // median of |x| of a normal distribution

/// Length of a sample's residual.
double distance(const Eigen::VectorXd& residuals, int sample, int rows) {
  return residuals.segment(sample * rows, rows).norm();
}

Eigen::MatrixXd rows_of(const ModalProblem& problem, const std::vector<bool>& used, Eigen::VectorXd& values) {
  const int rows = problem.rows_per_sample;
  const auto count = static_cast<int>(std::count(used.begin(), used.end(), true));
  Eigen::MatrixXd design(count * rows, problem.design.cols());
  values.resize(count * rows);
  for (int sample = 0, row = 0; sample < problem.samples(); ++sample) {
    if (!used[static_cast<std::size_t>(sample)]) continue;
    design.middleRows(row, rows) = problem.design.middleRows(sample * rows, rows);
    values.segment(row, rows) = problem.values.segment(sample * rows, rows);
    row += rows;
  }
  return design;
}

/// Residuals of the fit with the least sum of distances, by weights 1/distance. They only judge samples, so normal
/// equations are exact enough.
Eigen::VectorXd least_absolute_residuals(const ModalProblem& problem) {
  constexpr int rounds = 30;
  const int rows = problem.rows_per_sample;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(problem.values.size()), residuals;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::MatrixXd weighted = weights.asDiagonal() * problem.design;
    const Eigen::VectorXd c =
        (problem.design.transpose() * weighted).ldlt().solve(weighted.transpose() * problem.values);
    residuals = problem.values - problem.design * c;
    for (int sample = 0; sample < problem.samples(); ++sample)
      weights.segment(sample * rows, rows)
          .setConstant(1.0 / std::max(problem.negligible, distance(residuals, sample, rows)));
  }
  return residuals;
}

/// Sizes of the residuals of what is used, the smallest first.
std::vector<double> sizes_of(const ModalProblem& problem, const Eigen::VectorXd& residuals,
                             const std::vector<bool>& used) {
  std::vector<double> sizes;
  for (int row = 0; row < residuals.size(); ++row)
    if (used[static_cast<std::size_t>(row / problem.rows_per_sample)]) sizes.push_back(std::abs(residuals[row]));
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

/// Standard deviation of the noise by the median of sizes from the first one that counts, which a minority of bad ones
/// hardly moves.
double deviation_from(const std::vector<double>& sizes, std::size_t first) {
  return sizes[first + (sizes.size() - first) / 2] / normal_quartile;
}

/// The fit with the least sum of distances goes through about as many values as it has modes; the others tell the
/// noise.
double deviation_of_least_absolute(const ModalProblem& problem, const Eigen::VectorXd& residuals) {
  const std::vector<bool> all(static_cast<std::size_t>(problem.samples()), true);
  return deviation_from(sizes_of(problem, residuals, all), problem.modes.size());
}

/// Least squares leave √(1 − modes/values) of the noise in each residual. None where there are no more values than
/// modes.
std::optional<double> deviation_of_least_squares(const ModalProblem& problem, const ModalFit& fit) {
  const std::vector<double> sizes = sizes_of(problem, fit.residuals, fit.used);
  const auto values = static_cast<double>(sizes.size()), modes = static_cast<double>(problem.modes.size());
  if (!(values > modes)) return std::nullopt;
  return deviation_from(sizes, 0) / std::sqrt(1.0 - modes / values);
}

std::vector<bool> without_spurious(const ModalProblem& problem, const Eigen::VectorXd& residuals, double deviation) {
  const double limit = std::max(problem.negligible, spurious_distance * deviation);
  std::vector<bool> used(static_cast<std::size_t>(problem.samples()));
  for (int sample = 0; sample < problem.samples(); ++sample)
    used[static_cast<std::size_t>(sample)] = distance(residuals, sample, problem.rows_per_sample) <= limit;
  return used;
}

/// Each used sample's residual in the fit to all others is (I − H)⁻¹ r with its block H of the hat matrix.
std::optional<double> left_out_rms(const ModalProblem& problem, const ModalFit& fit) {
  constexpr double least_pivot = 1e-9;
  const int rows = problem.rows_per_sample;
  double sum = 0.0;
  int count = 0;
  for (int sample = 0; sample < problem.samples(); ++sample) {
    if (!fit.used[static_cast<std::size_t>(sample)]) continue;
    const Eigen::MatrixXd block = problem.design.middleRows(sample * rows, rows);
    const Eigen::MatrixXd rest =
        Eigen::MatrixXd::Identity(rows, rows) - block * fit.unit_covariance * block.transpose();
    const LeastSquares left_out = small_least_squares(rest, fit.residuals.segment(sample * rows, rows));
    if (left_out.singular_values.minCoeff() < least_pivot) return std::nullopt;
    sum += left_out.solution.squaredNorm();
    count += rows;
  }
  return std::sqrt(sum / count);
}

}  // namespace

std::vector<int> modes_of_slopes(int radial_order) {
  std::vector<int> modes;
  for (int j = 1; j < (radial_order + 1) * (radial_order + 2) / 2; ++j) modes.push_back(j);
  return modes;
}

ModalProblem slope_problem(const std::vector<SlopeSample>& samples, const std::vector<int>& modes, double pupil_radius,
                           double lenslet) {
  static const std::vector<QuadratureNode> nodes = gauss_legendre(11);  // exact for order 20
  const double h = 0.5 * lenslet / pupil_radius;
  const auto count = static_cast<Eigen::Index>(samples.size());
  ModalProblem problem{modes, Eigen::MatrixXd(2 * count, modes.size()), Eigen::VectorXd(2 * count), 2, 1e-7};
  for (Eigen::Index i = 0; i < count; ++i)
    problem.values.segment<2>(2 * i) = samples[static_cast<std::size_t>(i)].slope;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const PlanePolynomial z = zernike_polynomial(modes[m]), zx = z.derivative_x(), zy = z.derivative_y();
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Vector2d p = samples[static_cast<std::size_t>(i)].point / pupil_radius;
      Eigen::Vector2d mean(zx(p.x(), p.y()), zy(p.x(), p.y()));
      if (h > 0.0) {  // the mean of a derivative along its side is the difference of the ends
        mean.setZero();
        for (const QuadratureNode& node : nodes) {
          const double x = p.x() + h * node.x, y = p.y() + h * node.x;
          mean.x() += 0.25 * node.weight / h * (z(p.x() + h, y) - z(p.x() - h, y));
          mean.y() += 0.25 * node.weight / h * (z(x, p.y() + h) - z(x, p.y() - h));
        }
      }
      problem.design.block<2, 1>(2 * i, static_cast<Eigen::Index>(m)) = mean / pupil_radius;
    }
  }
  return problem;
}

ModalProblem height_problem(const std::vector<HeightSample>& samples, const std::vector<int>& modes,
                            double pupil_radius) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  ModalProblem problem{modes, Eigen::MatrixXd(count, modes.size()), Eigen::VectorXd(count), 1, 1e-10};
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const PlanePolynomial z = zernike_polynomial(modes[m]);
    for (Eigen::Index i = 0; i < count; ++i) {
      const HeightSample& sample = samples[static_cast<std::size_t>(i)];
      problem.values[i] = sample.height;
      problem.design(i, static_cast<Eigen::Index>(m)) =
          z(sample.point.x() / pupil_radius, sample.point.y() / pupil_radius);
    }
  }
  return problem;
}

double ModalFit::standard_error(int i, double noise_deviation) const {
  return noise_deviation * std::sqrt(unit_covariance(i, i));
}

ModalFit fit_modes(const ModalProblem& problem, const std::vector<bool>& used) {
  constexpr double least_ratio = 1e-9;  // of singular values
  Eigen::VectorXd values;
  const Eigen::MatrixXd design = rows_of(problem, used, values);
  if (design.rows() < design.cols())
    throw UndeterminedFit(std::to_string(design.rows()) + " values for " + std::to_string(design.cols()) + " modes");
  LeastSquares solved = least_squares(design, values);
  const Eigen::VectorXd& singular = solved.singular_values;
  if (!(singular.minCoeff() > least_ratio * singular.maxCoeff()))
    throw UndeterminedFit("the points do not tell the " + std::to_string(design.cols()) + " modes apart");
  ModalFit fit;
  fit.modes = problem.modes;
  fit.coefficients = std::move(solved.solution);
  fit.unit_covariance = std::move(solved.unit_covariance);
  fit.condition_number = singular.maxCoeff() / singular.minCoeff();
  fit.residuals = problem.values - problem.design * fit.coefficients;
  fit.used = used;
  const double square = (values - design * fit.coefficients).squaredNorm();
  fit.residual_rms = std::sqrt(square / static_cast<double>(design.rows()));
  const auto spare = design.rows() - design.cols();
  if (spare > 0) {
    fit.noise = std::sqrt(square / static_cast<double>(spare));
    fit.left_out_rms = left_out_rms(problem, fit);
  }
  return fit;
}

ModalFit fit_modes_robustly(const ModalProblem& problem) {
  constexpr int rounds = 20;
  if (problem.design.rows() <= problem.design.cols())
    return fit_modes(problem, std::vector<bool>(static_cast<std::size_t>(problem.samples()), true));
  const Eigen::VectorXd first = least_absolute_residuals(problem);
  ModalFit fit = fit_modes(problem, without_spurious(problem, first, deviation_of_least_absolute(problem, first)));
  for (int round = 0; round < rounds; ++round) {
    const std::optional<double> deviation = deviation_of_least_squares(problem, fit);
    if (!deviation) break;
    const std::vector<bool> next = without_spurious(problem, fit.residuals, *deviation);
    if (next == fit.used) break;
    fit = fit_modes(problem, next);
  }
  return fit;
}

}  // namespace sturm
