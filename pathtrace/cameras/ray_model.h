#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "lensmodel/eye.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// Rays that a model could not launch, or launched oddly
/// (docs/theory.md#51-metalstigmatism-its-pole-and-the-emmetrope), and those that spectacles stopped.
struct RayCounters {
  std::uint64_t launched = 0;
  std::uint64_t dropped = 0;         ///< at the pole |1 + d_f P| < 1e-6
  std::uint64_t negative_focus = 0;  ///< bent as if by a focus behind the eye, f < 0
  std::uint64_t lost_rim = 0, lost_total_reflection = 0, lost_no_convergence = 0;  ///< in the spectacles

  RayCounters& operator+=(const RayCounters& other) {
    launched += other.launched;
    dropped += other.dropped;
    negative_focus += other.negative_focus;
    lost_rim += other.lost_rim;
    lost_total_reflection += other.lost_total_reflection;
    lost_no_convergence += other.lost_no_convergence;
    return *this;
  }
};

/// Only rays before `dropped` go on into the scene. A dropped ray is no sample at all; a lost one is a sample of black.
enum class LaunchStatus : std::uint8_t {
  ok,
  negative_focus,
  dropped,
  lost_rim,
  lost_total_reflection,
  lost_no_convergence
};

inline bool goes_on(LaunchStatus status) {
  return status < LaunchStatus::dropped;
}

/// A ray as it leaves the pupil: point p [m] and slope s [rad], wearer frame.
template <class T>
struct PupilRay {
  T px, py, sx, sy;
  LaunchStatus status;
};

/// Calls f with the model as a compile-time constant.
template <class Function>
auto for_model(RayModel model, Function&& f) {
  switch (model) {
    case RayModel::pinhole:
      return f(std::integral_constant<RayModel, RayModel::pinhole>{});
    case RayModel::thin_lens:
      return f(std::integral_constant<RayModel, RayModel::thin_lens>{});
    case RayModel::metalstigmatism:
      return f(std::integral_constant<RayModel, RayModel::metalstigmatism>{});
    case RayModel::sin2_radial:
      return f(std::integral_constant<RayModel, RayModel::sin2_radial>{});
    case RayModel::zernike:
      return f(std::integral_constant<RayModel, RayModel::zernike>{});
    default:
      return f(std::integral_constant<RayModel, RayModel::power_matrix>{});
  }
}

/// The rays of one eye in one state of accommodation. The renderer's camera uses it in float, ray bundles in double:
/// the same code.
template <class T>
class EyeRays {
 public:
  /// `accommodation_D` is A. `focus_distance_m` is d_f for metalstigmatism (∞ allowed); other models ignore it.
  EyeRays(RayModel model, const Eye& eye, double accommodation_D,
          double focus_distance_m = std::numeric_limits<double>::infinity())
      : model_(model),
        radius_(model == RayModel::pinhole ? T(0) : T(eye.pupil_radius_m)),
        xx_(T(eye.correction.xx())),
        xy_(T(eye.correction.xy())),
        yy_(T(eye.correction.yy())),
        sxx_(T(eye.correction.xx() - accommodation_D)),
        syy_(T(eye.correction.yy() - accommodation_D)),
        accommodation_(T(accommodation_D)),
        scalar_slope_(T(eye.correction.spherical_equivalent() - accommodation_D)),
        focus_distance_(T(focus_distance_m)) {
    if (model != RayModel::zernike) return;
    const ZernikeWave wave =
        eye.wavefront.value_or(ZernikeWave::of_power(eye.correction, std::max(eye.pupil_radius_m, 1e-3)));
    wave_slope_x_ = wave.slope_x();
    wave_slope_y_ = wave.slope_y();
    inverse_wave_radius_ = 1.0 / wave.radius_m();
  }

  RayModel model() const { return model_; }
  T pupil_radius() const { return radius_; }

  /// S = F − A·I of wavefront theory, whatever the model.
  Eigen::Matrix<T, 2, 2> slope_matrix() const { return Eigen::Matrix<T, 2, 2>{{sxx_, xy_}, {xy_, syy_}}; }

  /// The ray through the pupil point (px, py) [m].
  PupilRay<T> through(T px, T py) const {
    return for_model(model_, [&](auto model) { return through_as<model>(px, py); });
  }

  /// The same with the model known at compile time, for loops over many rays of one eye.
  template <RayModel model>
  PupilRay<T> through_as(T px, T py) const {
    if constexpr (model == RayModel::pinhole)
      return {T(0), T(0), T(0), T(0), LaunchStatus::ok};  // the chief ray, whatever p
    if constexpr (model == RayModel::thin_lens)
      return {px, py, scalar_slope_ * px, scalar_slope_ * py, LaunchStatus::ok};
    if constexpr (model == RayModel::power_matrix)
      return {px, py, sxx_ * px + xy_ * py, xy_ * px + syy_ * py, LaunchStatus::ok};
    if constexpr (model == RayModel::sin2_radial) {
      const T power = meridional_power(px, py) - accommodation_;
      return {px, py, power * px, power * py, LaunchStatus::ok};
    }
    if constexpr (model == RayModel::zernike) {
      const double x = inverse_wave_radius_ * px, y = inverse_wave_radius_ * py;
      return {px, py, T(wave_slope_x_(x, y)) - accommodation_ * px, T(wave_slope_y_(x, y)) - accommodation_ * py,
              LaunchStatus::ok};
    }
    if constexpr (model == RayModel::metalstigmatism) return focal_distances_added(px, py);
  }

 private:
  /// P(φ) = S + C sin²(φ − α_w) of the meridian through (px, py), written as the quadratic form pᵀF p / |p|² (Euler's
  /// theorem).
  T meridional_power(T px, T py) const {
    const T square = px * px + py * py;
    return square > T(0) ? (xx_ * px * px + T(2) * xy_ * px * py + yy_ * py * py) / square : T(0);
  }

  /// METALSTIGMATISM as printed: f = d_f + 1/P, slope −p/f = −p·P/(1 + d_f P).
  PupilRay<T> focal_distances_added(T px, T py) const {
    if (std::isinf(focus_distance_)) return {px, py, T(0), T(0), LaunchStatus::ok};
    const T power = meridional_power(px, py);
    const T denominator = T(1) + focus_distance_ * power;
    if (std::abs(denominator) < T(1e-6)) return {px, py, T(0), T(0), LaunchStatus::dropped};
    const T slope = -power / denominator;
    return {px, py, slope * px, slope * py, slope > T(0) ? LaunchStatus::negative_focus : LaunchStatus::ok};
  }

  RayModel model_;
  T radius_;
  T xx_, xy_, yy_;  // F
  T sxx_, syy_;     // diagonal of S = F − A·I
  T accommodation_, scalar_slope_, focus_distance_;
  PlanePolynomial wave_slope_x_, wave_slope_y_;  // −∇W in p/radius, in double for either T: high orders cancel
  double inverse_wave_radius_ = 0.0;
};

/// Counts what became of one ray of a naked eye.
inline void count(RayCounters& counters, LaunchStatus status) {
  ++counters.launched;
  counters.dropped += status == LaunchStatus::dropped;
  counters.negative_focus += status == LaunchStatus::negative_focus;
}

/// The same for a ray that may have been lost in spectacles.
inline void count_with_losses(RayCounters& counters, LaunchStatus status) {
  count(counters, status);
  counters.lost_rim += status == LaunchStatus::lost_rim;
  counters.lost_total_reflection += status == LaunchStatus::lost_total_reflection;
  counters.lost_no_convergence += status == LaunchStatus::lost_no_convergence;
}

}  // namespace sturm
