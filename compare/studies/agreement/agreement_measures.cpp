#include "compare/studies/agreement/agreement_measures.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "compare/images/image_comparison.h"
#include "compare/statistics/jackknife.h"

namespace sturm {

namespace {

bool inside(const Image* mask, std::size_t pixel) {
  return !mask || mask->pixels[pixel] > 0.0f;
}

/// Mean of squared differences over the channels of the pixels of a mask.
double mean_square(const Image& a, const Image& b, const Image* mask) {
  double sum = 0.0;
  std::size_t count = 0;
  const auto channels = static_cast<std::size_t>(a.channels);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (!inside(mask, i / channels)) continue;
    const double d = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
    sum += d * d;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// The first value is of all replicates, the others with one left out.
ReplicateMean jackknifed(const std::vector<double>& values) {
  return {values.front(), jackknife_standard_error(std::span(values).subspan(1))};
}

int margin_of(const Image& picture, const Ssim& similarity) {
  return (picture.width - similarity.map.width) / 2;
}

}  // namespace

ReplicatePictures::ReplicatePictures(std::vector<Image> images)
    : images_(std::move(images)), mean_(mean_of(0, images_.size())) {}

Image ReplicatePictures::mean_of(std::size_t first, std::size_t last, std::optional<std::size_t> left_out) const {
  Image result(images_.front().width, images_.front().height, images_.front().channels);
  const double n = static_cast<double>(last - first) - (left_out ? 1.0 : 0.0);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    double sum = 0.0;
    for (std::size_t r = first; r < last; ++r)
      if (r != left_out) sum += static_cast<double>(images_[r].pixels[i]);
    result.pixels[i] = static_cast<float>(sum / n);
  }
  return result;
}

double ReplicatePictures::variance(const Image* mask) const {
  double sum = 0.0;
  for (const Image& image : images_) sum += mean_square(image, mean_, mask);
  return sum / (count() - 1.0);
}

PredictionErrors::PredictionErrors(const ReplicatePictures& reference, const ReplicatePictures& predicted)
    : reference_(reference), predicted_(predicted) {
  samples_.push_back(sample(std::nullopt));
  for (std::size_t k = 0; k < predicted.images().size(); ++k) samples_.push_back(sample(k));
}

PredictionErrors::Sample PredictionErrors::sample(std::optional<std::size_t> left_out) const {
  Sample result{reference_.mean_of(0, reference_.images().size(), left_out), {}, {}};
  for (std::size_t i = 0; i < predicted_.images().size(); ++i) {
    if (i == left_out) continue;
    result.predicted.push_back(&predicted_.images()[i]);
    result.similarities.push_back(ssim(predicted_.images()[i], result.reference));
  }
  return result;
}

ErrorParts PredictionErrors::within(const Image* mask) const {
  ErrorParts parts;
  const Image& mean_picture = reference_.mean();
  const std::size_t all = static_cast<std::size_t>(mean_picture.width) * static_cast<std::size_t>(mean_picture.height);
  for (std::size_t i = 0; i < all; ++i) parts.pixels += inside(mask, i) ? 1 : 0;
  const double one = reference_.variance(mask);
  parts.reference_noise = one / reference_.count();
  parts.prediction_noise = predicted_.variance(mask);
  std::vector<double> squares, roots;
  for (const Sample& s : samples_) {
    std::vector<double> errors, roots_of_errors;
    for (const Image* image : s.predicted) {
      errors.push_back(mean_square(*image, s.reference, mask) - one / static_cast<double>(s.predicted.size()));
      roots_of_errors.push_back(std::sqrt(std::max(0.0, errors.back())));
    }
    squares.push_back(mean(errors));
    roots.push_back(mean(roots_of_errors));
  }
  parts.mean_square = jackknifed(squares);
  parts.rmse = jackknifed(roots);
  parts.error = parts.mean_square.value;
  parts.raw = parts.error + parts.reference_noise;
  return parts;
}

ReplicateMean PredictionErrors::similarity() const {
  std::vector<double> values;
  for (const Sample& s : samples_) {
    std::vector<double> means;
    for (const Ssim& one : s.similarities) means.push_back(one.mean);
    values.push_back(mean(means));
  }
  return jackknifed(values);
}

std::optional<ReplicateMean> PredictionErrors::similarity(const Image& mask) const {
  std::vector<double> values;
  for (const Sample& s : samples_) {
    std::vector<double> means;
    for (const Ssim& one : s.similarities) {
      const std::vector<double> local = values_within(one.map, margin_of(mask, one), mask);
      if (local.empty()) return std::nullopt;
      means.push_back(mean(local));
    }
    values.push_back(mean(means));
  }
  return jackknifed(values);
}

double PredictionErrors::share_of_similarity_loss(const Image& mask) const {
  double lost = 0.0, of_all = 0.0;
  for (const Ssim& s : samples_.front().similarities) {
    for (const double v : values_within(s.map, margin_of(mask, s), mask)) lost += 1.0 - v;
    of_all += (1.0 - s.mean) * static_cast<double>(s.map.pixels.size());
  }
  return of_all > 0.0 ? lost / of_all : 0.0;
}

SimilarityLoss PredictionErrors::similarity_loss() const {
  const std::size_t count = reference_.images().size(), half = count / 2;
  const Image first = reference_.mean_of(0, half), second = reference_.mean_of(half, count);
  double against_halves = 0.0;
  for (const Image& image : predicted_.images())
    against_halves += 0.5 * (ssim(image, first).mean + ssim(image, second).mean) / predicted_.count();
  const double full = similarity().value, of_mean = ssim(predicted_.mean(), reference_.mean()).mean;
  const double n = reference_.count(), h = static_cast<double>(half);
  const double noise = 1.0 / n, noise_of_half = 0.5 * (1.0 / h + 1.0 / (n - h));
  SimilarityLoss loss;
  loss.total = 1.0 - full;
  loss.reference_noise = (full - against_halves) * noise / (noise_of_half - noise);
  loss.prediction_noise = (of_mean - full) * predicted_.count() / (predicted_.count() - 1.0);
  loss.method = loss.total - loss.reference_noise - loss.prediction_noise;
  return loss;
}

}  // namespace sturm
