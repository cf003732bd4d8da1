#include "compare/images/paired_bias.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sturm {

namespace {

/// ⟨d_i, d_j⟩ of two differences, per pixel and channel.
double mean_product(const Image& a, const Image& b, const Image& other_a, const Image& other_b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.pixels.size(); ++k)
    sum +=
        (static_cast<double>(a.pixels[k]) - b.pixels[k]) * (static_cast<double>(other_a.pixels[k]) - other_b.pixels[k]);
  return sum / static_cast<double>(a.pixels.size());
}

}  // namespace

PairedBias paired_bias(const std::vector<Image>& test, const std::vector<Image>& reference) {
  const std::size_t n = test.size();
  if (n < 3 || reference.size() != n)
    throw std::invalid_argument("a paired bias needs at least three pictures of each kind");
  for (const std::vector<Image>* images : {&test, &reference})
    for (const Image& image : *images)
      if (image.pixels.empty() || image.pixels.size() != test[0].pixels.size())
        throw std::invalid_argument("a paired bias needs pictures of one size");

  const double pairs = 0.5 * static_cast<double>(n * (n - 1));
  double sum = 0.0, squares = 0.0;
  std::vector<double> of_picture(n, 0.0);  // the products that a picture takes part in
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double product = mean_product(test[i], reference[i], test[j], reference[j]);
      sum += product;
      squares += product * product;
      of_picture[i] += product;
      of_picture[j] += product;
    }

  PairedBias bias;
  bias.mean_square = sum / pairs;
  const double pairs_without_one = 0.5 * static_cast<double>((n - 1) * (n - 2));
  double deviations = 0.0, mean_left_out = 0.0;
  for (const double of_one : of_picture) mean_left_out += (sum - of_one) / pairs_without_one / static_cast<double>(n);
  for (const double of_one : of_picture) deviations += std::pow((sum - of_one) / pairs_without_one - mean_left_out, 2);
  bias.standard_error = std::sqrt(deviations * static_cast<double>(n - 1) / static_cast<double>(n));
  const double error_without_bias = std::sqrt(std::max(0.0, squares - sum * sum / pairs) / ((pairs - 1.0) * pairs));
  bias.z = error_without_bias > 0.0 ? bias.mean_square / error_without_bias : 0.0;
  return bias;
}

}  // namespace sturm
