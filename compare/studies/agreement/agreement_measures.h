#pragma once
#include <optional>
#include <vector>

#include "compare/metrics/ssim.h"
#include "io/images/image.h"

namespace sturm {

/// A mean over replicates with its jackknife error, replicate k of the reference and of the prediction left out
/// together: it counts the noise of both.
struct ReplicateMean {
  double value = 0.0, uncertainty = 0.0;
};

/// At least two independently seeded pictures of one view, all of one size, in display space.
class ReplicatePictures {
 public:
  explicit ReplicatePictures(std::vector<Image> images);

  const std::vector<Image>& images() const { return images_; }
  const Image& mean() const { return mean_; }
  Image mean_of(std::size_t first, std::size_t last,
                std::optional<std::size_t> left_out = {}) const;  ///< of first … last − 1, but one
  double count() const { return static_cast<double>(images_.size()); }

  /// Variance of a single picture about its expectation, from the scatter, mean over the channels of the pixels of a
  /// mask (null: all).
  double variance(const Image* mask) const;

 private:
  std::vector<Image> images_;
  Image mean_;
};

/// Mean squares over the channels of a region's pixels.
struct ErrorParts {
  std::size_t pixels = 0;
  double reference_noise = 0.0;   ///< variance of the reference's mean
  double prediction_noise = 0.0;  ///< variance of a single prediction
  double error = 0.0;             ///< of a single prediction against the reference's expectation
  double method() const { return error - prediction_noise; }  ///< what no sample takes away; noise may make it negative
  ReplicateMean rmse;         ///< √error of each prediction (0 where noise makes it negative)
  ReplicateMean mean_square;  ///< `error` with its uncertainty
  double raw = 0.0;           ///< squared differences from the reference's mean, noise and all
};

/// Where the similarity that is missing to 1 went. The parts add up to `total`, and a part that is lost in noise may be
/// negative.
struct SimilarityLoss {
  double total = 0.0, reference_noise = 0.0, prediction_noise = 0.0, method = 0.0;
};

/// Replicates of a prediction against replicates of its reference.
///
/// All splits rest on replicates alone. Squares: E|P − T̄|² = |E P − E T|² + var P + var T/R. Similarity: SSIM falls in
/// proportion to a small variance of either picture, so against halves of the reference it falls by the more that their
/// variance is higher, and the mean of the predictions gains what their own variance costs; both are extrapolated to
/// none.
class PredictionErrors {
 public:
  /// `reference` and `predicted` outlive it and are as many.
  PredictionErrors(const ReplicatePictures& reference, const ReplicatePictures& predicted);

  ErrorParts within(const Image* mask) const;  ///< null: the whole picture
  ReplicateMean similarity() const;            ///< of single predictions with the reference's mean
  std::optional<ReplicateMean> similarity(const Image& mask) const;  ///< none where no window's middle lies in the mask
  double share_of_similarity_loss(const Image& mask) const;
  SimilarityLoss similarity_loss() const;

 private:
  /// Some of the predictions against the mean of as many path-traced pictures.
  struct Sample {
    Image reference;
    std::vector<const Image*> predicted;
    std::vector<Ssim> similarities;
  };
  Sample sample(std::optional<std::size_t> left_out) const;

  const ReplicatePictures& reference_;
  const ReplicatePictures& predicted_;
  std::vector<Sample> samples_;  ///< all, then all but number 0, 1, …
};

}  // namespace sturm
