#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compare/images/image_comparison.h"
#include "compare/images/noise_floor.h"
#include "compare/images/regions.h"

namespace sturm {

/// One metric on one part of the picture, and what noise makes of it.
struct MetricResult {
  std::optional<double> value;          ///< none where the metric has none, as the PSNR of equal pictures
  std::optional<NoiseFloor> noise;      ///< where seeds were given
  std::optional<bool> distinguishable;  ///< z above the threshold of the family; none where there is no z
};

/// All metrics on one part of the picture, in the order of `image_metric_names`.
struct PartResult {
  std::string name;                   ///< "whole", or that of the region
  std::size_t pixels = 0;             ///< in this part
  std::vector<MetricResult> metrics;  ///< in the order of `image_metric_names`
};

/// Two pictures by all metrics, on the whole and on its regions.
struct PictureComparison {
  std::vector<ImageMetric> metrics;   ///< with their maps
  std::vector<PartResult> parts;      ///< the whole picture first
  std::size_t tests = 0;              ///< tests against the noise floor that were made
  std::optional<double> z_threshold;  ///< one-sided, for a false-alarm rate of `family_level` over all of them
};

/// Family-wise chance that any figure of two pictures that differ by noise alone is called distinguishable.
inline constexpr double noise_family_level = 0.01;

/// `test_seed`, `reference_seed` (may be null): the same views with other seeds. The exposures of HDR-FLIP and all
/// other conditions are the same for the comparison and for the seeds. Throws InputError as `measure_images`.
PictureComparison compare_pictures(const Image& test, const Image& reference, const std::vector<Region>& regions,
                                   const ImageMetricSettings& settings, const Image* test_seed = nullptr,
                                   const Image* reference_seed = nullptr);

}  // namespace sturm
