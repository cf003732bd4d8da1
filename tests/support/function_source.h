#pragma once
#include <functional>

#include "pathtrace/film/pixel_source.h"
#include "pathtrace/sampling/sequence.h"

namespace sturm::testing {

/// Pixels whose samples are a function of two numbers of a sequence: pictures whose mean is known, in no time.
class FunctionSource : public PixelSource {
 public:
  using Function = std::function<float(int x, int y, float u, float v)>;

  FunctionSource(int width, int height, Sequence sequence, std::uint64_t seed, Function function)
      : width_(width), height_(height), sequence_(sequence), seed_(seed), function_(std::move(function)) {}

  int width() const override { return width_; }
  int height() const override { return height_; }

  void add_samples(int x, int y, const SampleRange& range, const PixelRecords& records,
                   RenderCounters& counters) const override {
    const PixelSequence sequence(sequence_, seed_ + (std::uint64_t{1} << 54) * static_cast<std::uint64_t>(range.stream),
                                 static_cast<std::uint32_t>(y * width_ + x));
    for (std::uint32_t i = 0; i < range.count; ++i) {
      const auto u = sequence.pair(range.first + i, 0);
      records.radiance.add(Eigen::Vector3f::Constant(function_(x, y, unit_float(u.x), unit_float(u.y))));
      records.first_hit.add_miss();
      ++counters.camera.launched;
    }
  }

 private:
  int width_, height_;
  Sequence sequence_;
  std::uint64_t seed_;
  Function function_;
};

}  // namespace sturm::testing
