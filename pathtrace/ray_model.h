#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "lensmodel/eye.h"

namespace sturm {

/// How the eye bends the ray that leaves it through a pupil point (physics.md §4).
enum class RayModel { pinhole, thin_lens, metalstigmatism, sin2_radial, power_matrix };

std::optional<RayModel> ray_model_named(std::string_view name);
std::string name_of(RayModel model);

/// Rays that a model could not launch, or launched oddly; physics.md §4 (metalstigmatism).
struct RayCounters {
  std::uint64_t launched = 0;
  std::uint64_t dropped = 0;         ///< at the pole |1 + d_f P| < 1e-6
  std::uint64_t negative_focus = 0;  ///< bent as if by a focus behind the eye, f < 0

  RayCounters& operator+=(const RayCounters& other) {
    launched += other.launched;
    dropped += other.dropped;
    negative_focus += other.negative_focus;
    return *this;
  }
};

enum class LaunchStatus : std::uint8_t { ok, negative_focus, dropped };

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
    default:
      return f(std::integral_constant<RayModel, RayModel::power_matrix>{});
  }
}

/// The rays of one eye in one state of accommodation. The renderer's camera uses it in float, ray bundles in double: the same code.
template <class T>
class EyeRays {
 public:
  /// `accommodation_D` is A. `focus_distance_m` is d_f for metalstigmatism (∞ allowed); other models ignore it.
  EyeRays(RayModel model, const Eye& eye, double accommodation_D, double focus_distance_m = std::numeric_limits<double>::infinity())
      : model_(model),
        radius_(model == RayModel::pinhole ? T(0) : T(eye.pupil_radius_m)),
        xx_(T(eye.correction.xx())),
        xy_(T(eye.correction.xy())),
        yy_(T(eye.correction.yy())),
        sxx_(T(eye.correction.xx() - accommodation_D)),
        syy_(T(eye.correction.yy() - accommodation_D)),
        accommodation_(T(accommodation_D)),
        scalar_slope_(T(eye.correction.spherical_equivalent() - accommodation_D)),
        focus_distance_(T(focus_distance_m)) {}

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
    if constexpr (model == RayModel::pinhole) return {T(0), T(0), T(0), T(0), LaunchStatus::ok};  // the chief ray, whatever p
    if constexpr (model == RayModel::thin_lens) return {px, py, scalar_slope_ * px, scalar_slope_ * py, LaunchStatus::ok};
    if constexpr (model == RayModel::power_matrix) return {px, py, sxx_ * px + xy_ * py, xy_ * px + syy_ * py, LaunchStatus::ok};
    if constexpr (model == RayModel::sin2_radial) {
      const T power = meridional_power(px, py) - accommodation_;
      return {px, py, power * px, power * py, LaunchStatus::ok};
    }
    if constexpr (model == RayModel::metalstigmatism) return focal_distances_added(px, py);
  }

 private:
  /// P(φ) = S + C sin²(φ − α_w) of the meridian through (px, py), written as the quadratic form pᵀF p / |p|² (Euler's theorem).
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
};

/// Counts what became of one ray.
inline void count(RayCounters& counters, LaunchStatus status) {
  ++counters.launched;
  counters.dropped += status == LaunchStatus::dropped;
  counters.negative_focus += status == LaunchStatus::negative_focus;
}

}  // namespace sturm
