#pragma once
#include <cstdint>

#include "pathtrace/film/film.h"
#include "pathtrace/film/render.h"

namespace sturm {

/// Samples first … first + count − 1 of one of the independent streams of a pixel. Stream 0 is what a picture in one go
/// takes.
struct SampleRange {
  int stream = 0;
  std::uint32_t first = 0, count = 0;
};

/// Where the samples of a pixel are added; `guide` may be null.
struct PixelRecords {
  PixelStatistics& radiance;
  FirstHitStatistics& first_hit;
  GuideStatistics* guide = nullptr;
};

/// Makes samples of pixels, each a function of (seed, stream, pixel, sample number) alone. Streams of a pixel are
/// scrambled independently.
class PixelSource {
 public:
  virtual ~PixelSource() = default;
  virtual int width() const = 0;
  virtual int height() const = 0;

  /// Adds samples of pixel (x, y) to the records, in order. Safe to call from several threads for different pixels.
  virtual void add_samples(int x, int y, const SampleRange& range, const PixelRecords& records,
                           RenderCounters& counters) const = 0;
};

}  // namespace sturm
