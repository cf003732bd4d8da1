#include "compare/studies/bench/curve.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace sturm {

namespace {

struct LogPoint {
  double x, y;  // log seconds, log error
};

/// By rising seconds; of several settings that take equally long the best one.
std::vector<LogPoint> log_curve(std::span<const CostPoint> points) {
  std::vector<LogPoint> curve;
  for (const CostPoint& p : points) curve.push_back({std::log(p.seconds), std::log(p.error)});
  std::sort(curve.begin(), curve.end(),
            [](const LogPoint& p, const LogPoint& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  curve.erase(std::unique(curve.begin(), curve.end(), [](const LogPoint& p, const LogPoint& q) { return p.x == q.x; }),
              curve.end());
  return curve;
}

/// Height of a curve at x inside its range.
double height(const std::vector<LogPoint>& curve, double x) {
  const auto right =
      std::lower_bound(curve.begin(), curve.end(), x, [](const LogPoint& p, double value) { return p.x < value; });
  if (right == curve.begin() || right->x == x) return right->y;
  const LogPoint& left = *(right - 1);
  return left.y + (right->y - left.y) * (x - left.x) / (right->x - left.x);
}

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const CostPoint> points) {
  const double n = static_cast<double>(points.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (const CostPoint& p : points) mean_x += std::log(p.samples) / n, mean_y += std::log(p.error) / n;
  double xx = 0.0, xy = 0.0, propagated = 0.0;
  bool all_known = true;
  for (const CostPoint& p : points) {
    const double x = std::log(p.samples) - mean_x, relative = p.standard_error.value_or(0.0) / p.error;
    xx += x * x;
    xy += x * (std::log(p.error) - mean_y);
    propagated += x * x * relative * relative;
    all_known = all_known && p.standard_error;
  }
  const auto [least, most] = std::minmax_element(
      points.begin(), points.end(), [](const CostPoint& p, const CostPoint& q) { return p.samples < q.samples; });
  if (points.size() < 2 || most->samples < 2.0 * least->samples) return std::nullopt;
  PowerLaw law;
  law.slope = xy / xx;
  if (all_known) law.standard_error = std::sqrt(propagated) / xx;
  if (points.size() > 2) {
    double residuals = 0.0;
    for (const CostPoint& p : points) {
      const double residual = std::log(p.error) - mean_y - law.slope * (std::log(p.samples) - mean_x);
      residuals += residual * residual;
    }
    law.standard_error = std::max(law.standard_error.value_or(0.0), std::sqrt(residuals / ((n - 2.0) * xx)));
  }
  return law;
}

std::vector<std::size_t> pareto_front(std::span<const CostPoint> points) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CostPoint& p = points[i];
    const bool beaten = std::any_of(points.begin(), points.end(), [&](const CostPoint& q) {
      return q.seconds <= p.seconds && q.error <= p.error && (q.seconds < p.seconds || q.error < p.error);
    });
    if (!beaten) front.push_back(i);
  }
  std::stable_sort(front.begin(), front.end(),
                   [&](std::size_t i, std::size_t j) { return points[i].seconds < points[j].seconds; });
  return front;
}

TimeToReach time_to_reach(std::span<const CostPoint> points, double level) {
  const std::vector<LogPoint> curve = log_curve(points);
  const double y = std::log(level);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].y > y) continue;
    if (i == 0) return {Reach::AtOnce, std::exp(curve[0].x), std::nullopt};
    const LogPoint &p = curve[i - 1], &q = curve[i];
    const double slope = (q.y - p.y) / (q.x - p.x);
    return {Reach::Interpolated, std::exp(p.x + (y - p.y) / slope), slope};
  }
  return {};
}

std::vector<Crossover> crossovers(std::span<const CostPoint> a, std::span<const CostPoint> b) {
  const std::vector<LogPoint> curve_a = log_curve(a), curve_b = log_curve(b);
  if (curve_a.empty() || curve_b.empty()) return {};
  const double first = std::max(curve_a.front().x, curve_b.front().x),
               last = std::min(curve_a.back().x, curve_b.back().x);
  std::set<double> corners;
  for (const auto* curve : {&curve_a, &curve_b})
    for (const LogPoint& p : *curve)
      if (p.x >= first && p.x <= last) corners.insert(p.x);
  std::vector<Crossover> result;
  std::optional<LogPoint> before;  // the last corner where the curves differ; y: log error of a over b
  double meeting = 0.0;            // the first corner after it where they meet
  bool touching = false;
  for (const double x : corners) {
    const double difference = height(curve_a, x) - height(curve_b, x);
    if (difference == 0.0) {
      if (!touching) meeting = x;
      touching = true;
      continue;
    }
    if (before && (before->y > 0.0) != (difference > 0.0)) {
      const double at = touching ? meeting : before->x + (x - before->x) * before->y / (before->y - difference);
      result.push_back({std::exp(at), std::exp(height(curve_a, at)), difference < 0.0});
    }
    before = LogPoint{x, difference};
    touching = false;
  }
  return result;
}

}  // namespace sturm
