#include "compare/studies/bench/measured_view.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "compare/statistics/median.h"

namespace sturm {

const std::array<ErrorKind, 4> error_kinds = {
    {{"rmse", "RMSE", &PictureErrors::mse, true, true},
     {"relative_mse", "relative MSE", &PictureErrors::relative_mse, false, true},
     {"relative_mse_trimmed", "trimmed relative MSE", &PictureErrors::relative_mse_trimmed, false, false},
     {"one_minus_ssim", "1 − SSIM", &PictureErrors::one_minus_ssim, false, false}}};

const ErrorKind& error_kind(std::string_view name) {
  for (const ErrorKind& kind : error_kinds)
    if (kind.name == name) return kind;
  throw std::invalid_argument("no error is called " + std::string(name));
}

ErrorEstimate estimate(const MeasuredSetting& setting, const PictureErrors& noise_floor, const ErrorKind& kind) {
  const double n = static_cast<double>(setting.rounds.size()), floor = noise_floor.*kind.of;
  double mean = 0.0, squares = 0.0;
  for (const BenchSample& round : setting.rounds) mean += round.errors.*kind.of / n;
  for (const BenchSample& round : setting.rounds) {
    const double deviation = round.errors.*kind.of - mean;
    squares += deviation * deviation;
  }
  const double left = kind.floor_taken_off ? mean - floor : mean, uncertainty = std::sqrt(squares / (n * (n - 1.0)));
  ErrorEstimate e;
  e.raw = kind.is_root ? std::sqrt(mean) : mean;
  e.status = !(left > 0.0) ? FloorStatus::Below : floor > 0.5 * mean ? FloorStatus::Near : FloorStatus::Clear;
  if (left > 0.0) {
    e.value = kind.is_root ? std::sqrt(left) : left;
    e.standard_error = kind.is_root ? uncertainty / (2.0 * *e.value) : uncertainty;
  }
  return e;
}

double median_seconds(const MeasuredSetting& setting) {
  std::vector<double> seconds;
  for (const BenchSample& round : setting.rounds) seconds.push_back(round.seconds);
  return median(std::move(seconds)).value();
}

double mean_samples(const MeasuredSetting& setting) {
  double sum = 0.0;
  for (const BenchSample& round : setting.rounds) sum += round.samples;
  return sum / static_cast<double>(setting.rounds.size());
}

MethodCurve curve_of(const MeasuredView& view, std::string_view method, const ErrorKind& kind) {
  MethodCurve curve;
  for (const MeasuredSetting& setting : view.settings) {
    if (setting.method != method) continue;
    const ErrorEstimate error = estimate(setting, view.noise_floor, kind);
    if (!error.value) continue;
    curve.points.push_back({mean_samples(setting), median_seconds(setting), *error.value, error.standard_error});
    curve.samples_per_pixel.push_back(setting.samples_per_pixel);
    curve.labels.push_back(setting.label);
  }
  return curve;
}

double error_seconds(const CostPoint& point, const ErrorKind& kind) {
  return (kind.is_root ? point.error * point.error : point.error) * point.seconds;
}

}  // namespace sturm
