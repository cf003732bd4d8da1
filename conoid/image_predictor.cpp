#include "conoid/image_predictor.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "conoid/disocclusion.h"
#include "conoid/ellipse_kernel.h"
#include "lensmodel/symmetric2.h"

namespace sturm {
namespace {

constexpr int bins_per_layer = 64;
constexpr int rows_per_band = 8;
constexpr double largest_radius_px = 16384.0;  // keeps kernels and layer numbers bounded; no image is that wide

/// The blur of one eye in image pixels, as a function of vergence 1/d.
class PixelBlur {
 public:
  PixelBlur(const Eye& eye, double accommodation_D, double pixel_slope)
      : slope_matrix_(eye.slope_matrix(accommodation_D).matrix()), scale_(eye.pupil_radius_m / pixel_slope) {}

  /// Takes the unit disc to image offsets [px], x right, y down: −a V / pixel size with the second row turned over.
  Eigen::Matrix2d map(double vergence_D) const {
    Eigen::Matrix2d m = -scale_ * (vergence_D * Eigen::Matrix2d::Identity() + slope_matrix_);
    m.row(1) = -m.row(1);
    return m;
  }

  double semi_major_px(double vergence_D) const { return singular_values(map(vergence_D)).large; }

  /// Pupil radius / pixel size: how many pixels the semi-axes change per dioptre.
  double px_per_dioptre() const { return scale_; }

 private:
  Eigen::Matrix2d slope_matrix_;
  double scale_;
};

constexpr std::int32_t copied = -1;

/// One source pixel. Samples are sorted by layer, then by row.
struct Sample {
  std::int64_t layer;   ///< ascending from near to far
  std::int32_t x, y;    ///< output pixel that holds it; outside of the output in the guard band
  std::int32_t phase;   ///< which of the oversampling² places in that pixel
  std::int32_t kernel;  ///< index among the layer's kernels, or `copied`
  double vergence_D;
  float rgb[3];
};

/// Sums in double: a bright lamp spread over many pixels must not swallow its dim neighbours (physics.md §9.4).
struct Light {
  double rgb[3] = {0.0, 0.0, 0.0};
  double coverage = 0.0;

  void add(const Light& other) {
    for (int c = 0; c < 3; ++c) rgb[c] += other.rgb[c];
    coverage += other.coverage;
  }
};

Light weighted(const Sample& sample, double weight) {
  return {{weight * sample.rgb[0], weight * sample.rgb[1], weight * sample.rgb[2]}, weight};
}

void check(const SharpView& view, const PredictorSettings& settings) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(std::string("sharp view: ") + message);
  };
  require(view.radiance.channels == 3 && view.depth.channels == 1, "expected 3 radiance channels and 1 depth channel");
  require(view.radiance.width == view.depth.width && view.radiance.height == view.depth.height, "radiance and depth differ in size");
  require(view.oversampling >= 1 && view.margin_px >= 0, "oversampling below 1 or negative margin");
  const int width = view.radiance.width - 2 * view.margin_px, height = view.radiance.height - 2 * view.margin_px;
  require(width > 0 && height > 0, "nothing is left inside the guard band");
  require(width % view.oversampling == 0 && height % view.oversampling == 0, "size without guard band is no multiple of the oversampling");
  require(view.pixel_slope > 0.0 && std::isfinite(view.pixel_slope), "pixel slope must be positive");
  require(settings.layer_width_px > 0.0 && settings.sharp_below_px >= 0.0, "settings must be positive");
  for (const float value : view.radiance.pixels) require(std::isfinite(value), "radiance is not finite");
  for (const float value : view.depth.pixels) require(value > 0.0f, "depth is not positive");  // also refuses NaN
}

class Predictor {
 public:
  Predictor(const SharpView& view, const Eye& eye, double accommodation_D, const PredictorSettings& settings)
      : view_(view),
        settings_(settings),
        n_(view.oversampling),
        width_((view.radiance.width - 2 * view.margin_px) / n_),
        height_((view.radiance.height - 2 * view.margin_px) / n_),
        blur_(eye, accommodation_D, view.pixel_slope * n_),
        layer_(static_cast<std::size_t>(width_) * height_),
        total_(layer_.size()) {}

  Prediction run() {
    collect_samples();
    for (std::size_t begin = 0; begin < samples_.size();) {
      std::size_t end = begin;
      while (end < samples_.size() && samples_[end].layer == samples_[begin].layer) ++end;
      ++counters_.layers;
      prepare_kernels(begin, end);
      spread_layer(begin, end);
      begin = end;
    }
    return finished();
  }

 private:
  void collect_samples() {
    const Image& radiance = view_.radiance;
    std::vector<double> vergence(view_.depth.pixels.size());
    for (std::size_t i = 0; i < vergence.size(); ++i) vergence[i] = 1.0 / static_cast<double>(view_.depth.pixels[i]);  // 1/∞ = 0
    for (const double extreme : {*std::min_element(vergence.begin(), vergence.end()), *std::max_element(vergence.begin(), vergence.end())})
      if (!(blur_.semi_major_px(extreme) <= largest_radius_px))
        throw std::invalid_argument("sharp view: a blur ellipse exceeds 16384 pixels");
    for (int y = 0; y < radiance.height; ++y)
      for (int x = 0; x < radiance.width; ++x)
        add_sample(x, y, vergence[static_cast<std::size_t>(y) * radiance.width + x], radiance.at(x, y));
    if (blur_.px_per_dioptre() > 0.0) {
      // A step of one sharp pixel of blur per sharp pixel is where a surface's own blur begins to fold over: an edge from there on.
      const double jump_D = 1.0 / (n_ * blur_.px_per_dioptre());
      const auto reach = [&](double vergence_D) { return n_ * blur_.semi_major_px(vergence_D); };
      for (const HiddenSample& hidden : extrapolate_hidden(radiance, vergence, jump_D, reach)) {
        add_sample(hidden.x, hidden.y, hidden.vergence_D, hidden.rgb.data());
        ++counters_.hidden_pixels;
      }
    }
    std::sort(samples_.begin(), samples_.end(), [](const Sample& a, const Sample& b) {
      return std::tie(a.layer, a.y, a.x, a.phase, b.vergence_D) < std::tie(b.layer, b.y, b.x, b.phase, a.vergence_D);
    });
  }

  void add_sample(int x, int y, double vergence_D, const float* rgb) {
    const auto split = [&](int sharp, std::int32_t& output) {  // floor division: the guard band is negative
      const int inside = sharp - view_.margin_px;
      output = inside >= 0 ? inside / n_ : -((-inside + n_ - 1) / n_);
      return inside - output * n_;
    };
    Sample s{};
    const int u = split(x, s.x), v = split(y, s.y);
    s.phase = v * n_ + u;
    s.vergence_D = vergence_D;
    s.layer = -static_cast<std::int64_t>(std::floor(layer_coordinate(vergence_D)));
    std::copy(rgb, rgb + 3, s.rgb);
    samples_.push_back(s);
  }

  /// Layers from infinity inwards; each holds vergences over which the semi-axes change by layer_width_px.
  double layer_coordinate(double vergence_D) const { return vergence_D * blur_.px_per_dioptre() / settings_.layer_width_px; }

  int bin_of(const Sample& s) const {
    const double within = layer_coordinate(s.vergence_D) + static_cast<double>(s.layer);
    return std::clamp(static_cast<int>(within * bins_per_layer), 0, bins_per_layer - 1);
  }

  /// One kernel per used bin of vergence and place in the pixel; a bin's vergence is the middle of those it holds.
  void prepare_kernels(std::size_t begin, std::size_t end) {
    struct Range {
      double low = std::numeric_limits<double>::infinity(), high = 0.0;
    };
    std::vector<Range> range(bins_per_layer);
    for (std::size_t i = begin; i < end; ++i) {
      Range& r = range[bin_of(samples_[i])];
      r.low = std::min(r.low, samples_[i].vergence_D);
      r.high = std::max(r.high, samples_[i].vergence_D);
    }
    std::vector<Eigen::Matrix2d> maps(bins_per_layer);
    std::vector<bool> sharp(bins_per_layer, false);
    for (int bin = 0; bin < bins_per_layer; ++bin) {
      if (range[bin].low > range[bin].high) continue;
      const double vergence_D = 0.5 * (range[bin].low + range[bin].high);
      maps[bin] = blur_.map(vergence_D);
      const double radius = blur_.semi_major_px(vergence_D);
      sharp[bin] = radius < settings_.sharp_below_px;
      if (radius * n_ > view_.margin_px && !sharp[bin]) counters_.clipped_radius_px = std::max(counters_.clipped_radius_px, radius);
    }

    const int phases = n_ * n_;
    std::vector<std::int32_t> index(static_cast<std::size_t>(bins_per_layer) * phases, copied);
    std::vector<std::size_t> used;
    for (std::size_t i = begin; i < end; ++i) {
      Sample& s = samples_[i];
      const int bin = bin_of(s);
      s.kernel = copied;
      ++(sharp[bin] ? counters_.sharp_pixels : counters_.splatted_pixels);
      if (sharp[bin]) continue;
      const std::size_t key = static_cast<std::size_t>(bin) * phases + s.phase;
      if (index[key] == copied) {
        index[key] = static_cast<std::int32_t>(used.size());
        used.push_back(key);
      }
      s.kernel = index[key];
    }
    kernels_.assign(used.size(), EllipseKernel(Eigen::Matrix2d::Zero(), {0.5, 0.5}));
    tbb::parallel_for(std::size_t{0}, used.size(), [&](std::size_t k) {
      const int phase = static_cast<int>(used[k] % phases);
      const Eigen::Vector2d source((phase % n_ + 0.5) / n_, (phase / n_ + 0.5) / n_);
      kernels_[k] = EllipseKernel(maps[used[k] / phases], source);
    });
  }

  /// Bands of output rows in parallel: each pixel is summed by one thread, in the order of the samples.
  void spread_layer(std::size_t begin, std::size_t end) {
    int reach_up = 0, reach_down = 0;
    for (const EllipseKernel& k : kernels_) {
      reach_up = std::max(reach_up, -k.first_row());
      reach_down = std::max(reach_down, k.first_row() + static_cast<int>(k.rows().size()) - 1);
    }
    const int first_row = std::max(0, samples_[begin].y - reach_up), end_row = std::min(height_, samples_[end - 1].y + reach_down + 1);
    if (first_row >= end_row) return;
    const auto samples_begin = samples_.begin() + begin, samples_end = samples_.begin() + end;
    tbb::parallel_for(first_row / rows_per_band, (end_row - 1) / rows_per_band + 1, [&](int band) {
      const int row0 = band * rows_per_band, row1 = std::min(height_, row0 + rows_per_band);
      std::fill(layer_.begin() + static_cast<std::size_t>(row0) * width_, layer_.begin() + static_cast<std::size_t>(row1) * width_,
                Light{});
      auto s = std::lower_bound(samples_begin, samples_end, row0 - reach_down, [](const Sample& a, int row) { return a.y < row; });
      for (; s != samples_end && s->y < row1 + reach_up; ++s) spread(*s, row0, row1);
      composite(row0, row1);
    });
  }

  void spread(const Sample& s, int row0, int row1) {
    if (s.kernel == copied) {
      if (s.x >= 0 && s.x < width_ && s.y >= row0 && s.y < row1) layer_[static_cast<std::size_t>(s.y) * width_ + s.x].add(weighted(s, 1.0));
      return;
    }
    const EllipseKernel& kernel = kernels_[s.kernel];
    const Light inner = weighted(s, kernel.inner_weight());
    const int top = s.y + kernel.first_row();
    const int y_end = std::min(row1, top + static_cast<int>(kernel.rows().size()));
    for (int y = std::max(row0, top); y < y_end; ++y) {
      const EllipseKernel::Row& row = kernel.rows()[y - top];
      Light* const out = &layer_[static_cast<std::size_t>(y) * width_];
      const auto clipped = [&](int column) { return std::clamp(s.x + column, 0, width_); };
      const auto add_edges = [&](int from, int to, const double* weights) {
        for (int x = clipped(from), x_end = clipped(to); x < x_end; ++x) out[x].add(weighted(s, weights[x - s.x - from]));
      };
      const double* const weights = kernel.edge_weights().data() + row.edges;
      add_edges(row.begin, row.inner_begin, weights);
      for (int x = clipped(row.inner_begin), x_end = clipped(row.inner_end); x < x_end; ++x) out[x].add(inner);
      add_edges(row.inner_end, row.end, weights + (row.inner_begin - row.begin));
    }
  }

  void composite(int row0, int row1) {
    const double per_sample = 1.0 / (n_ * n_);  // a full pixel holds oversampling² samples
    for (std::size_t i = static_cast<std::size_t>(row0) * width_; i < static_cast<std::size_t>(row1) * width_; ++i) {
      const double alpha = layer_[i].coverage * per_sample;
      const double added = std::min(alpha, 1.0 - total_[i].coverage);
      if (!(added > 0.0)) continue;
      const double scale = per_sample * (added / alpha);
      for (int c = 0; c < 3; ++c) total_[i].rgb[c] += scale * layer_[i].rgb[c];
      total_[i].coverage += added;
    }
  }

  Prediction finished() const {
    Prediction result{Image(width_, height_, 3), Image(width_, height_, 1), counters_};
    for (std::size_t i = 0; i < total_.size(); ++i) {
      // Never zero: every ellipse covers its own centre, so a pixel gets at least its own light.
      for (int c = 0; c < 3; ++c) result.radiance.pixels[3 * i + c] = static_cast<float>(total_[i].rgb[c] / total_[i].coverage);
      result.coverage.pixels[i] = static_cast<float>(total_[i].coverage);
    }
    return result;
  }

  const SharpView& view_;
  const PredictorSettings& settings_;
  const int n_, width_, height_;
  const PixelBlur blur_;
  std::vector<Sample> samples_;
  std::vector<EllipseKernel> kernels_;  // of the current layer
  std::vector<Light> layer_, total_;
  PredictionCounters counters_;
};

}  // namespace

Prediction predict_image(const SharpView& view, const Eye& eye, double accommodation_D, const PredictorSettings& settings) {
  check(view, settings);
  return Predictor(view, eye, accommodation_D, settings).run();
}

int required_margin_px(const Eye& eye, double accommodation_D, double pixel_slope, double nearest_m, double farthest_m) {
  if (!(nearest_m > 0.0 && farthest_m >= nearest_m && pixel_slope > 0.0))
    throw std::invalid_argument("guard band: expected 0 < nearest <= farthest");
  const PixelBlur blur(eye, accommodation_D, pixel_slope);
  // The larger semi-axis is a norm of a matrix that is affine in the vergence: convex, so largest at an end.
  return static_cast<int>(std::ceil(std::max(blur.semi_major_px(1.0 / nearest_m), blur.semi_major_px(1.0 / farthest_m))));
}

}  // namespace sturm
