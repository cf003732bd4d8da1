#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/metrics/flip.h"
#include "compare/metrics/hdr_flip.h"
#include "io/images/image.h"

namespace sturm {

/// Conditions that the values depend on.
struct ImageMetricSettings {
  double exposure = 1.0;                                      ///< factor before the display transfer function
  double pixels_per_degree = flip_default_pixels_per_degree;  ///< of the observer, for FLIP and HDR-FLIP; > 0
  std::optional<ExposureRange> hdr_exposures;  ///< of HDR-FLIP; none: by the rule for the reference picture
};

/// A metric of two pictures, and where it comes from.
struct ImageMetric {
  std::string key;              ///< in JSON
  std::string title;            ///< in tables
  bool more_is_better = false;  ///< a similarity; otherwise an error
  std::optional<double> value;  ///< of the whole picture; none: infinite or not defined for it (PSNR of equal pictures,
                                ///< MS-SSIM of small ones)

  /// Local values, one channel; map pixel (x, y) belongs to image pixel (x + margin, y + margin). The metric is a mean
  /// of them, or a function of their mean (root, decibel); of MS-SSIM it is a picture for orientation. Empty where
  /// `value` is not defined for the picture, and for trimmed means, which are none of the whole map.
  Image map;
  int margin = 0;                  ///< pixels of the picture that the map lacks on each side
  int window_px = 1;               ///< side of the square of pixels that a local value depends on
  bool map_is_similarity = false;  ///< larger local values are better (the map of a PSNR holds squared errors)

  /// The value within a mask of the picture's size (1 inside, 0 outside); none where no local value is inside.
  std::function<std::optional<double>(const Image& mask)> within;
};

/// All metrics of two pictures in linear Rec. 709 light (3 channels), in the order of the tables. Throws InputError
/// where the pictures cannot be compared or are below 11 × 11 pixels.
std::vector<ImageMetric> measure_images(const Image& test, const Image& reference, const ImageMetricSettings& settings);

/// The metrics' keys, titles and directions without any picture.
struct ImageMetricName {
  const char *key, *title;  ///< in JSON and in tables
  bool more_is_better;      ///< a similarity; otherwise an error
};
const std::vector<ImageMetricName>& image_metric_names();  ///< in the order of measure_images

/// Map values inside the mask (above 0), in the order of the map's pixels.
std::vector<double> values_within(const Image& map, int margin, const Image& mask);

}  // namespace sturm
