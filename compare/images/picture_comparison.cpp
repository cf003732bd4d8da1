#include "compare/images/picture_comparison.h"

#include "compare/statistics/test_family.h"

namespace sturm {

namespace {

/// Metrics between seeds, one list for each of the two views that has a second one.
using SeedMetrics = std::vector<std::vector<ImageMetric>>;

PartResult part_of(const std::vector<ImageMetric>& metrics, const SeedMetrics& seeds, std::string name,
                   std::size_t pixels, const Image* mask) {
  PartResult part{std::move(name), pixels, {}};
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    MetricResult result;
    result.value = mask ? metrics[i].within(*mask) : metrics[i].value;
    if (!seeds.empty()) {
      std::vector<const ImageMetric*> between;
      for (const auto& list : seeds) between.push_back(&list[i]);
      result.noise = noise_floor(metrics[i], between, mask);
    }
    part.metrics.push_back(std::move(result));
  }
  return part;
}

}  // namespace

PictureComparison compare_pictures(const Image& test, const Image& reference, const std::vector<Region>& regions,
                                   const ImageMetricSettings& given, const Image* test_seed,
                                   const Image* reference_seed) {
  ImageMetricSettings settings = given;
  if (!settings.hdr_exposures) settings.hdr_exposures = hdr_flip_exposures(reference);
  PictureComparison c;
  c.metrics = measure_images(test, reference, settings);
  SeedMetrics seeds;
  if (test_seed) seeds.push_back(measure_images(test, *test_seed, settings));
  if (reference_seed) seeds.push_back(measure_images(reference, *reference_seed, settings));
  c.parts.push_back(part_of(c.metrics, seeds, "whole", static_cast<std::size_t>(test.width) * test.height, nullptr));
  for (const Region& region : regions)
    c.parts.push_back(part_of(c.metrics, seeds, region.name, region.pixels(), &region.mask));

  TestFamily family(noise_family_level);
  for (const PartResult& part : c.parts)
    for (std::size_t i = 0; i < part.metrics.size(); ++i)
      if (part.metrics[i].noise && part.metrics[i].noise->z)
        family.add(part.name + " " + c.metrics[i].key, *part.metrics[i].noise->z);
  c.tests = family.tests();
  if (c.tests == 0) return c;
  c.z_threshold = family.one_sided_threshold();
  for (PartResult& part : c.parts)
    for (MetricResult& m : part.metrics)
      if (m.noise && m.noise->z) m.distinguishable = *m.noise->z > *c.z_threshold;
  return c;
}

}  // namespace sturm
