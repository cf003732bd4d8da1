#include "compare/metrics/rmse.h"

#include <cmath>

#include "compare/metrics/comparable.h"

namespace sturm {

double rmse(const Image& test, const Image& reference) {
  require_comparable(test, reference);
  double sum = 0.0;
  for (std::size_t i = 0; i < test.pixels.size(); ++i) {
    const double difference = static_cast<double>(test.pixels[i]) - reference.pixels[i];
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(test.pixels.size()));
}

double psnr_dB(const Image& test, const Image& reference, double peak) {
  return 20.0 * std::log10(peak / rmse(test, reference));
}

}  // namespace sturm
