#include "conoid/pictures/image_predictor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "conoid/pictures/ellipse_kernel.h"
#include "conoid/pictures/layer_compositor.h"
#include "conoid/threads/parallel_for.h"
#include "io/images/disocclusion.h"
#include "lensmodel/symmetric2.h"

namespace sturm {
namespace {

constexpr int bins_per_layer = 64;

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

constexpr std::int32_t copied = LayerCompositor::Spot::copied;

/// One source pixel. Samples are sorted by layer, then by row.
struct Sample {
  std::int64_t layer;   ///< ascending from near to far
  std::int32_t x, y;    ///< output pixel that holds it; outside of the output in the guard band
  std::int32_t phase;   ///< which of the oversampling² places in that pixel
  std::int32_t kernel;  ///< index among the layer's kernels, or `copied`
  double vergence_D;
  float rgb[3];
};

void check(const SharpView& view, const PredictorSettings& settings) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(std::string("sharp view: ") + message);
  };
  require(view.radiance.channels == 3 && view.depth.channels == 1, "expected 3 radiance channels and 1 depth channel");
  require(view.radiance.width == view.depth.width && view.radiance.height == view.depth.height,
          "radiance and depth differ in size");
  require(view.oversampling >= 1 && view.margin_px >= 0, "oversampling below 1 or negative margin");
  const int width = view.radiance.width - 2 * view.margin_px, height = view.radiance.height - 2 * view.margin_px;
  require(width > 0 && height > 0, "nothing is left inside the guard band");
  require(width % view.oversampling == 0 && height % view.oversampling == 0,
          "size without guard band is no multiple of the oversampling");
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
        compositor_(width_, height_, n_ * n_) {}

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
    // No pixel is empty: every ellipse covers its own centre, so a pixel gets at least its own light.
    return {compositor_.radiance(), compositor_.coverage(), counters_};
  }

 private:
  void collect_samples() {
    const Image& radiance = view_.radiance;
    std::vector<double> vergence(view_.depth.pixels.size());
    for (std::size_t i = 0; i < vergence.size(); ++i)
      vergence[i] = 1.0 / static_cast<double>(view_.depth.pixels[i]);  // 1/∞ = 0
    for (const double extreme :
         {*std::min_element(vergence.begin(), vergence.end()), *std::max_element(vergence.begin(), vergence.end())})
      if (!(blur_.semi_major_px(extreme) <= largest_blur_radius_px))
        throw std::invalid_argument("sharp view: a blur ellipse exceeds 16384 pixels");
    for (int y = 0; y < radiance.height; ++y)
      for (int x = 0; x < radiance.width; ++x)
        add_sample(x, y, vergence[static_cast<std::size_t>(y) * radiance.width + x], radiance.at(x, y));
    if (blur_.px_per_dioptre() > 0.0) {
      // A step of one sharp pixel of blur per sharp pixel is where a surface's own blur begins to fold over: an edge
      // from there on.
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
  double layer_coordinate(double vergence_D) const {
    return vergence_D * blur_.px_per_dioptre() / settings_.layer_width_px;
  }

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
      if (radius * n_ > view_.margin_px && !sharp[bin])
        counters_.clipped_radius_px = std::max(counters_.clipped_radius_px, radius);
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
    parallel_for(std::size_t{0}, used.size(), [&](std::size_t k) {
      const int phase = static_cast<int>(used[k] % phases);
      const Eigen::Vector2d source((phase % n_ + 0.5) / n_, (phase / n_ + 0.5) / n_);
      kernels_[k] = EllipseKernel(maps[used[k] / phases], source);
    });
  }

  void spread_layer(std::size_t begin, std::size_t end) {
    spots_.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const Sample& s = samples_[i];
      spots_.push_back({s.x, s.y, s.kernel, 1.0f, {s.rgb[0], s.rgb[1], s.rgb[2]}});
    }
    compositor_.add_layer(spots_, kernels_);
  }

  const SharpView& view_;
  const PredictorSettings& settings_;
  const int n_, width_, height_;
  const PixelBlur blur_;
  std::vector<Sample> samples_;
  std::vector<EllipseKernel> kernels_;  // of the current layer
  LayerCompositor compositor_;
  std::vector<LayerCompositor::Spot> spots_;
  PredictionCounters counters_;
};

}  // namespace

Prediction predict_image(const SharpView& view, const Eye& eye, double accommodation_D,
                         const PredictorSettings& settings) {
  check(view, settings);
  return Predictor(view, eye, accommodation_D, settings).run();
}

int required_margin_px(const Eye& eye, double accommodation_D, double pixel_slope, double nearest_m,
                       double farthest_m) {
  if (!(nearest_m > 0.0 && farthest_m >= nearest_m && pixel_slope > 0.0))
    throw std::invalid_argument("guard band: expected 0 < nearest <= farthest");
  const PixelBlur blur(eye, accommodation_D, pixel_slope);
  // The larger semi-axis is a norm of a matrix that is affine in the vergence: convex, so largest at an end.
  return static_cast<int>(
      std::ceil(std::max(blur.semi_major_px(1.0 / nearest_m), blur.semi_major_px(1.0 / farthest_m))));
}

}  // namespace sturm
