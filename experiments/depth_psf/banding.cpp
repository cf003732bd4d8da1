#include <cmath>
#include <numbers>

#include "experiments/depth_psf/depth_psf_study.h"
#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/ray_kernels.h"

namespace sturm {

namespace {

constexpr int width = 160, height = 400, column = 80;  // the middle of a stripe
constexpr int border = 40;                             // rows whose blur may reach beyond the picture
constexpr double period_px = 16.0, brightness = 0.5, contrast = 0.3, pixel_slope = 4e-4;

/// How the light of a pixel is shared out among planes, and the parts of the pupil that are composited.
struct Way {
  const char* weights;
  int parts;
};
constexpr Way ways[] = {{"nearest", 1}, {"linear", 1}, {"linear", 4}};

/// Upright stripes on a surface whose vergence grows evenly from row to row, seen by an eye in focus far away.
class StripedSlant {
 public:
  explicit StripedSlant(const BandingSpec& spec)
      : reach_(spec.reach_px_per_D),
        farthest_D_(1.0 / spec.farthest_m),
        slope_D_((1.0 / spec.nearest_m - farthest_D_) / (height - 1)) {
    for (int y = border; y < height - border; ++y) truth_.push_back(seen_at(y));
  }

  LayeredPicture picture() const {
    LayeredPicture picture;
    picture.radiance = Image(width, height, 3);
    picture.jump_D = 1.0 / reach_;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        picture.vergence_D.push_back(farthest_D_ + slope_D_ * y);
        std::fill_n(picture.radiance.at(x, y), 3,
                    static_cast<float>(brightness + contrast * std::cos(turns_per_px * x)));
      }
    return picture;
  }

  Eye eye() const { return Eye::with(Prescription{}, 2.0 * reach_ * pixel_slope); }

  void measure(const Image& seen, BandingRow& row) const {
    double square = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      const double error = error_at(seen, i);
      square += error * error;
      if (i > 0) largest = std::max(largest, std::abs(error - error_at(seen, i - 1)));
    }
    row.rmse = std::sqrt(square / static_cast<double>(truth_.size()));
    row.largest_step = largest;
  }

 private:
  static constexpr double turns_per_px = 2.0 * std::numbers::pi / period_px;
  static constexpr int rings = 40, spokes = 160;

  /// Through the pupil point p [px per dioptre] the pixel y shows the surface at (y + V₀ p_y)/(1 − s p_y), V = V₀ + s
  /// y, with its stripes moved by V p_x; the mean over the pupil is what is left of them. The linear shares of kernels
  /// among pixels take a squared sinc of that.
  double seen_at(int y) const {
    const double half = 0.5 * turns_per_px, shared = std::pow(std::sin(half) / half, 2.0);
    double left = 0.0;
    for (int ring = 0; ring < rings; ++ring)
      for (int spoke = 0; spoke < spokes; ++spoke) {
        const double r = reach_ * std::sqrt((ring + 0.5) / rings), angle = 2.0 * std::numbers::pi * spoke / spokes;
        const double up = r * std::sin(angle), place = (y + farthest_D_ * up) / (1.0 - slope_D_ * up);
        left += std::cos(turns_per_px * (farthest_D_ + slope_D_ * place) * r * std::cos(angle)) / (rings * spokes);
      }
    return brightness + contrast * shared * left;
  }

  double error_at(const Image& seen, std::size_t i) const {
    return seen.at(column, border + static_cast<int>(i))[0] - truth_[i];
  }

  double reach_, farthest_D_, slope_D_;
  std::vector<double> truth_;
};

double nearest_of(const std::vector<double>& planes_D, double vergence_D) {
  return *std::min_element(planes_D.begin(), planes_D.end(),
                           [&](double a, double b) { return std::abs(a - vergence_D) < std::abs(b - vergence_D); });
}

BandingRow banding_row(const StripedSlant& slant, const Way& way, double spacing_px) {
  const KernelModel model = ray_kernels(slant.eye(), 0.0, pixel_slope, {way.parts, false});
  LayeredPicture picture = slant.picture();
  const KernelBank bank(model, planes_for(picture.vergence_D, model.reach_px_per_D, spacing_px));
  if (way.weights == std::string("nearest"))
    for (double& vergence : picture.vergence_D) vergence = nearest_of(bank.planes_D(), vergence);
  BlurCounters work;
  BandingRow row{.spacing_px = spacing_px,
                 .weights = way.weights,
                 .pupil_parts = way.parts,
                 .planes = static_cast<std::int64_t>(bank.planes_D().size())};
  slant.measure(blur_layers(picture, bank, work), row);
  return row;
}

}  // namespace

std::vector<BandingRow> banding_rows(const BandingSpec& banding, const ProgressFunction& progress) {
  const StripedSlant slant(banding);
  std::vector<BandingRow> rows;
  for (const double spacing : banding.spacings_px)
    for (const Way& way : ways) {
      rows.push_back(banding_row(slant, way, spacing));
      progress(static_cast<double>(rows.size()) / static_cast<double>(banding.spacings_px.size() * std::size(ways)));
    }
  return rows;
}

}  // namespace sturm
