#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// What a picture lacks, in the orders and under the names of `error_names`.
struct PictureErrors {
  double mse = 0.0;                   ///< linear, over pixels and channels
  double relative_mse = 0.0;          ///< mean of (x − r)²/(r² + 0.01)
  double relative_mse_trimmed = 0.0;  ///< the same over the pixels that count, without the worst 0.1 % of those
  double one_minus_ssim = 0.0;        ///< 1 − SSIM, display space
};

/// A picture that others are measured against: the mean r of two independent halves a, b of equal noise.
///
/// Its own noise makes every squared error too large: with x independent of r and v the variance of r, E(x − r)² = E(x
/// − μ)² + v, and E(a − b)²/4 = v. So mean(x − r)² − mean(a − b)²/4 has the expectation of the true squared error:
/// exactly for the mean squared error; for the relative one the weight 1/(r² + 0.01) is itself noisy, which leaves a
/// bias of second order in the relative noise of r. Which pixels are the worst, and SSIM, are no means of squares:
/// nothing is taken off there, the floor is told instead.
class ReferenceImage {
 public:
  /// Throws InputError unless the halves are comparable 3-channel images of at least 11 × 11 pixels.
  /// `max_neighbourhood_radiance`: pixels do not count in the trimmed error where the mean of r over 3 × 3 pixels
  /// (fewer at the edge) and the channels is greater.
  ReferenceImage(const Image& first_half, const Image& second_half, std::optional<double> max_neighbourhood_radiance,
                 double exposure);

  const Image& mean() const { return mean_; }
  std::size_t pixels_left_out() const { return pixels_left_out_; }

  /// Throws InputError as `require_comparable`.
  PictureErrors errors_of(const Image& test) const;

  /// What the noise of r adds to mse and relative_mse; what it would add to the trimmed error if that were a mean; 1 −
  /// SSIM of the two halves, each of which is noisier than r.
  const PictureErrors& noise_floor() const { return floor_; }

 private:
  PictureErrors from_squares(const std::vector<double>& squared_differences) const;

  Image mean_, display_;
  double exposure_;
  std::vector<bool> counts_;  ///< by pixel, in the trimmed error
  std::size_t pixels_left_out_ = 0;
  PictureErrors floor_;
};

}  // namespace sturm
