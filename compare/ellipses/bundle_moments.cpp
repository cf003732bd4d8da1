#include "compare/ellipses/bundle_moments.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "lensmodel/symmetric2.h"

namespace sturm {

namespace {

constexpr double binomial[5][5] = {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};

Eigen::Vector3d entries(const Eigen::Matrix2d& m) {
  return {m(0, 0), 0.5 * (m(0, 1) + m(1, 0)), m(1, 1)};
}

/// √max(0, x): a quadratic form of a scatter matrix may come out as −1e-40.
double safe_root(double x) {
  return std::sqrt(std::max(0.0, x));
}

/// Covariance matrix of the mean of R vectors from their scatter: 1/(R(R − 1)) Σ (v − v̄)(v − v̄)ᵀ.
template <int N>
Eigen::Matrix<double, N, N> covariance_of_mean(const std::vector<Eigen::Matrix<double, N, 1>>& values,
                                               const Eigen::Matrix<double, N, 1>& mean) {
  Eigen::Matrix<double, N, N> scatter = Eigen::Matrix<double, N, N>::Zero();
  for (const auto& v : values) scatter += (v - mean) * (v - mean).transpose();
  const double r = static_cast<double>(values.size());
  return scatter / (r * (r - 1.0));
}

}  // namespace

void BundleMoments::add(const Eigen::Vector2d& point) {
  add(std::span<const Eigen::Vector2d>(&point, 1));
}

void BundleMoments::add(std::span<const Eigen::Vector2d> points) {
  constexpr std::size_t chunk =
      1024;  // small enough that plain sums keep their digits, large enough that merging costs nothing
  for (std::size_t first = 0; first < points.size(); first += chunk)
    merge(of_chunk(points.subspan(first, std::min(chunk, points.size() - first))));
}

BundleMoments BundleMoments::of_chunk(std::span<const Eigen::Vector2d> points) {
  BundleMoments m;
  m.count_ = points.size();
  const double n = static_cast<double>(points.size());
  Eigen::Vector2d total = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points)
    total += p - points.front();  // differences, so that equal points have no width at all
  m.mean_ = points.front() + total / n;
  for (const Eigen::Vector2d& p : points) {
    const double x = p.x() - m.mean_.x(), y = p.y() - m.mean_.y();
    const double xx = x * x, xy = x * y, yy = y * y;
    m.sums_[2][0] += xx, m.sums_[1][1] += xy, m.sums_[0][2] += yy;
    m.sums_[3][0] += xx * x, m.sums_[2][1] += xx * y, m.sums_[1][2] += x * yy, m.sums_[0][3] += yy * y;
    m.sums_[4][0] += xx * xx, m.sums_[3][1] += xx * xy, m.sums_[2][2] += xx * yy, m.sums_[1][3] += xy * yy,
        m.sums_[0][4] += yy * yy;
  }
  return m;
}

void BundleMoments::merge(const BundleMoments& other) {
  if (other.count_ == 0) return;
  if (count_ == 0) {
    *this = other;
    return;
  }
  const double na = static_cast<double>(count_), nb = static_cast<double>(other.count_), n = na + nb;
  const Eigen::Vector2d delta = other.mean_ - mean_;
  // Each side's deviations shift by a constant: −n_B/n·δ for this side, n_A/n·δ for the other; expand (d + shift)^p by
  // the binomial theorem.
  const auto shifted = [](const BundleMoments& m, const Eigen::Vector2d& shift, int p, int q) {
    double sum = 0.0, shift_x = 1.0;
    for (int i = 0; i <= p; ++i, shift_x *= shift.x()) {
      double shift_y = 1.0;
      for (int j = 0; j <= q; ++j, shift_y *= shift.y()) {
        const int order = p - i + q - j;
        if (order == 1) continue;  // first central moments vanish
        const double moment = order == 0 ? static_cast<double>(m.count_) : m.sums_[p - i][q - j];
        sum += binomial[p][i] * binomial[q][j] * moment * shift_x * shift_y;
      }
    }
    return sum;
  };
  CentralSums merged{};
  for (int p = 0; p <= 4; ++p)
    for (int q = 0; p + q <= 4; ++q)
      if (p + q >= 2) merged[p][q] = shifted(*this, -nb / n * delta, p, q) + shifted(other, na / n * delta, p, q);
  sums_ = merged;
  mean_ += nb / n * delta;
  count_ += other.count_;
}

Eigen::Matrix2d BundleMoments::covariance(PointSet kind) const {
  if (count_ < 2) return Eigen::Matrix2d::Zero();
  const double divisor = static_cast<double>(kind == PointSet::Independent ? count_ - 1 : count_);
  Eigen::Matrix2d c;
  c << sums_[2][0], sums_[1][1], sums_[1][1], sums_[0][2];
  return c / divisor;
}

std::optional<double> BundleMoments::kurtosis(const Eigen::Vector2d& direction) const {
  const double x = direction.x(), y = direction.y();
  const double second = x * x * sums_[2][0] + 2.0 * x * y * sums_[1][1] + y * y * sums_[0][2];
  if (!(second > 0.0)) return std::nullopt;
  double fourth = 0.0, power_x = 1.0;
  for (int p = 0; p <= 4; ++p, power_x *= x) fourth += binomial[4][p] * power_x * std::pow(y, 4 - p) * sums_[p][4 - p];
  return static_cast<double>(count_) * fourth / (second * second);
}

Eigen::Matrix3d BundleMoments::sampling_covariance() const {
  if (count_ == 0) return Eigen::Matrix3d::Zero();
  const double n = static_cast<double>(count_);
  const Eigen::Vector3d second(sums_[2][0] / n, sums_[1][1] / n, sums_[0][2] / n);
  Eigen::Matrix3d fourth;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) fourth(i, j) = sums_[4 - i - j][i + j] / n;  // entry i has i factors of y
  return (fourth - second * second.transpose()) / n;
}

Eigen::Vector3d entry_weights(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
  return {u.x() * v.x(), u.x() * v.y() + u.y() * v.x(), u.y() * v.y()};
}

std::optional<Eigen::Vector3d> BundleEllipse::covariance_standard_error() const {
  if (!entry_covariance) return std::nullopt;
  return Eigen::Vector3d(entry_covariance->diagonal().cwiseMax(0.0).cwiseSqrt());
}

std::optional<double> BundleEllipse::covariance_rel() const {
  const auto se = covariance_standard_error();
  const double norm = covariance.norm();
  if (!se || norm == 0.0) return std::nullopt;
  return std::sqrt(se->squaredNorm() + (*se)[1] * (*se)[1]) / norm;
}

std::optional<Eigen::Vector2d> BundleEllipse::semi_axis_standard_errors() const {
  if (!entry_covariance) return std::nullopt;
  const PrincipalValues p = principal_values(covariance(0, 0), covariance(0, 1), covariance(1, 1));
  const Eigen::Vector2d across(-p.high_direction.y(), p.high_direction.x());
  const auto error = [&](double value, const Eigen::Vector2d& u) {
    const Eigen::Vector3d w = entry_weights(u, u);
    const double se = safe_root(w.dot(*entry_covariance * w)), root = safe_root(value);
    return se == 0.0 ? 0.0 : 2.0 * se / (std::sqrt(std::max(0.0, value) + se) + root);
  };
  return Eigen::Vector2d(error(p.high, p.high_direction), error(p.low, across));
}

BundleEllipse summarise(std::span<const ReplicateMoments> replicates) {
  if (replicates.empty()) throw std::invalid_argument("summarise: no replicates");
  BundleEllipse e;
  e.replicates = static_cast<int>(replicates.size());
  const double r = static_cast<double>(replicates.size());
  std::vector<Eigen::Vector2d> centroids;
  std::vector<Eigen::Vector3d> covariances;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const ReplicateMoments& m : replicates) {
    e.points += m.points;
    centroids.push_back(m.mean);
    covariances.push_back(entries(m.covariance));
    e.centroid += centroids.back() / r;
    mean += covariances.back() / r;
  }
  e.covariance << mean[0], mean[1], mean[1], mean[2];
  e.ellipse = Ellipse::of_second_moments(e.covariance);
  if (replicates.size() > 1) {
    e.entry_covariance = covariance_of_mean<3>(covariances, mean);
    e.centroid_standard_error = covariance_of_mean<2>(centroids, e.centroid).diagonal().cwiseSqrt();
    e.degrees_of_freedom = r - 1.0;
  }
  return e;
}

BundleEllipse summarise(std::span<const BundleMoments> replicates, PointSet kind) {
  std::vector<ReplicateMoments> moments;
  for (const BundleMoments& m : replicates) {
    if (m.count() < 2) throw std::invalid_argument("summarise: a replicate has fewer than two points");
    moments.push_back({m.count(), m.mean(), m.covariance(kind)});
  }
  BundleEllipse e = summarise(moments);
  if (replicates.size() == 1 && kind == PointSet::Independent) {
    e.entry_covariance = replicates.front().sampling_covariance();
    e.centroid_standard_error = (e.covariance.diagonal() / static_cast<double>(e.points)).cwiseSqrt();
    e.degrees_of_freedom = static_cast<double>(e.points);
  }
  return e;
}

BundleEllipse ellipse_of_quadrature(std::span<const Eigen::Vector2d> points, std::span<const double> weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (points.size() != weights.size() || !(total > 0.0))
    throw std::invalid_argument("ellipse_of_quadrature: needs one weight per point, with a positive sum");
  BundleEllipse e;
  e.points = points.size();
  e.replicates = 1;
  for (std::size_t i = 0; i < points.size(); ++i) e.centroid += weights[i] / total * points[i];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d d = points[i] - e.centroid;
    e.covariance += weights[i] / total * d * d.transpose();
  }
  e.ellipse = Ellipse::of_second_moments(e.covariance);
  return e;
}

}  // namespace sturm
