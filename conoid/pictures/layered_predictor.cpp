#include "conoid/pictures/layered_predictor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "conoid/pictures/layer_compositor.h"
#include "conoid/pictures/surface_pieces.h"
#include "conoid/threads/parallel_for.h"
#include "lensmodel/symmetric2.h"

namespace sturm {
namespace {

using Eigen::Vector2d;

/// Places along each side that the sharp pixel of a lamp's rim is spread from. Cells of 1/n px lack n⁻²/12 px² of the
/// pixel's variance, which is little beside that of the blur, r²/4.
int lamp_grid(double radius_px) {
  return radius_px < 2.0 ? 8 : radius_px < 8.0 ? 4 : 2;
}

/// A piece of surface on its way to the picture.
struct Source : SurfacePiece {
  std::int64_t layer = 0;
  Eigen::Vector2d place{0.0, 0.0};                ///< that it is spread from, in output pixels
  Eigen::Matrix2d map = Eigen::Matrix2d::Zero();  ///< unit disc to output pixels
};

class Layers {
 public:
  Layers(const FragmentImage& view, int oversampling, const SightField& field, const PredictorSettings& settings)
      : view_(view), n_(oversampling), field_(field), settings_(settings) {
    const PicturePlane& plane = field.plane();
    if (view.width != plane.width * n_ || view.height != plane.height * n_)
      throw std::invalid_argument("layers: the sharp view does not cover the picture");
    px_per_dioptre_ = field.eye().pupil_radius_m / plane.pixel_slope;
  }

  Prediction run(const std::vector<UnseenPiece>& unseen) {
    for (const SurfacePiece& piece : surface_pieces(view_, n_, field_, unseen)) sources_.push_back({piece});
    counters_.hidden_pixels = static_cast<long long>(unseen.size());
    parallel_for(std::size_t{0}, sources_.size(), [&](std::size_t i) { blur(sources_[i]); });
    spread_lamps_from_all_over();
    for (const Source& s : sources_)
      if (!(singular_values(s.map).large <= largest_blur_radius_px))
        throw std::invalid_argument("layers: a blur ellipse exceeds 16384 pixels");
    std::stable_sort(sources_.begin(), sources_.end(), [&](const Source& a, const Source& b) {
      return std::tuple(a.layer, output(a.y), output(a.x)) < std::tuple(b.layer, output(b.y), output(b.x));
    });
    LayerCompositor compositor(field_.plane().width, field_.plane().height, n_ * n_);
    for (std::size_t begin = 0, end = 0; begin < sources_.size(); begin = end) {
      while (end < sources_.size() && sources_[end].layer == sources_[begin].layer) ++end;
      ++counters_.layers;
      add_layer(begin, end, compositor);
    }
    return {compositor.radiance(), compositor.coverage(), counters_};
  }

 private:
  int output(int sharp) const { return sharp >= 0 ? sharp / n_ : -((-sharp + n_ - 1) / n_); }
  Vector2d center(const Source& s) const { return {(s.x + 0.5) / n_, (s.y + 0.5) / n_}; }

  /// The place in the source's own sharp pixel that is `within` (0, 1)² of it, off its border.
  Vector2d within_pixel(const Source& s, const Vector2d& within) const {
    constexpr double border = 1e-3;
    return (Vector2d(s.x, s.y) + within.cwiseMax(border).cwiseMin(1.0 - border)) / n_;
  }

  void blur(Source& s) const {
    const Sight sight = field_.at(center(s));
    s.layer = -static_cast<std::int64_t>(std::floor(s.vergence_D * px_per_dioptre_ / settings_.layer_width_px));
    s.place = center(s);
    if (!sight.reaches) return;
    const SightNeighbourhood around(field_, center(s), sight);
    // A lamp is so bright that the rim of its ellipse shows where in the pixel it is; of all else the pixel's middle
    // will do.
    if (s.part) s.place = within_pixel(s, s.part->middle.cast<double>());
    s.map = field_.eye().pupil_radius_m * around.picture_map(field_.slopes(sight, s.vergence_D), s.vergence_D);
  }

  /// The part of its pixel that a lamp fills gives light to the next pixel as soon as blur is wider than what is
  /// between: spread from its middle, it would not, and of a lamp little is much. What is beside it does the same, or
  /// coverage would not add up to 1. The parallelogram of the same first and second moments stands for the part.
  void spread_lamps_from_all_over() {
    std::vector<Source> all;
    all.reserve(sources_.size());
    for (const Source& s : sources_) {
      if (!s.part) {
        all.push_back(s);
        continue;
      }
      const Eigen::Vector3d spread = 12.0 * s.part->spread.cast<double>();
      const double width = std::sqrt(spread[0]), shear = width > 0.0 ? spread[1] / width : 0.0;
      const double height = std::sqrt(std::max(0.0, spread[2] - shear * shear));
      const int n = lamp_grid(singular_values(s.map).large);
      for (int k = 0; k < n * n; ++k) {
        const double u = (k % n + 0.5) / n - 0.5, v = (k / n + 0.5) / n - 0.5;
        Source& part = all.emplace_back(s);
        part.coverage /= static_cast<float>(n * n);
        part.place = within_pixel(s, s.part->middle.cast<double>() + Vector2d(width * u, shear * u + height * v));
      }
    }
    sources_ = std::move(all);
  }

  void add_layer(std::size_t begin, std::size_t end, LayerCompositor& compositor) {
    std::vector<LayerCompositor::Spot> spots(end - begin);
    std::vector<EllipseKernel> kernels;
    std::vector<std::size_t> spread;
    for (std::size_t i = begin; i < end; ++i) {
      const Source& s = sources_[i];
      const bool sharp = singular_values(s.map).large < settings_.sharp_below_px;
      ++(sharp ? counters_.sharp_pixels : counters_.splatted_pixels);
      spots[i - begin] = {output(s.x),
                          output(s.y),
                          sharp ? LayerCompositor::Spot::copied : static_cast<std::int32_t>(spread.size()),
                          s.coverage,
                          {s.radiance.x(), s.radiance.y(), s.radiance.z()}};
      if (!sharp) spread.push_back(i);
    }
    kernels.assign(spread.size(), EllipseKernel(Eigen::Matrix2d::Zero(), {0.5, 0.5}));
    parallel_for(std::size_t{0}, spread.size(), [&](std::size_t k) {
      const Source& s = sources_[spread[k]];
      kernels[k] = EllipseKernel(s.map, s.place - Vector2d(output(s.x), output(s.y)));
    });
    compositor.add_layer(spots, kernels);
  }

  const FragmentImage& view_;
  int n_;
  const SightField& field_;
  PredictorSettings settings_;
  double px_per_dioptre_;
  std::vector<Source> sources_;
  PredictionCounters counters_;
};

}  // namespace

Prediction predict_by_layers(const FragmentImage& view, int oversampling, const SightField& field,
                             const std::vector<UnseenPiece>& unseen, const PredictorSettings& settings) {
  return Layers(view, oversampling, field, settings).run(unseen);
}

}  // namespace sturm
