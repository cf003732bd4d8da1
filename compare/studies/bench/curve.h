#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace sturm {

/// What one setting of a method costs and gives.
struct CostPoint {
  double samples = 0.0;                  ///< > 0
  double seconds = 0.0;                  ///< > 0
  double error = 0.0;                    ///< > 0
  std::optional<double> standard_error;  ///< of `error`
};

/// error ≈ c·samples^slope, by least squares on log-log axes, every point with the same weight: the points' own
/// standard errors come from few rounds and would make poor weights.
struct PowerLaw {
  double slope = 0.0;
  std::optional<double> standard_error;  ///< none for two points without standard errors
};

/// The standard error is the larger of two: what the points' standard errors σᵢ (relative, so of log error) propagate
/// to, √Σ(xᵢ − x̄)²σᵢ² / Σ(xᵢ − x̄)², and what the scatter about the line says (from three points on). None unless the
/// samples span a factor of two: predictions trace most of their rays whatever they are set to, and what is left of a
/// difference says nothing.
std::optional<PowerLaw> fit_power_law(std::span<const CostPoint> points);

/// Indices of the points that no other point beats (less of one and no more of the other of seconds and error), by
/// rising seconds.
std::vector<std::size_t> pareto_front(std::span<const CostPoint> points);

enum class Reach {
  Interpolated,  ///< between two settings, on log-log axes
  AtOnce,        ///< the cheapest setting is there already: the seconds are an upper bound
  Never          ///< no setting gets there: no seconds
};

struct TimeToReach {
  Reach reach = Reach::Never;
  std::optional<double> seconds;
  std::optional<double> slope;  ///< of log error against log seconds between the two settings, if interpolated: what
                                ///< errors do to the time
};

/// The time in which a method's error falls to `level` for the first time, going through its settings by rising
/// seconds.
TimeToReach time_to_reach(std::span<const CostPoint> points, double level);

/// Where two methods need the same time for the same error; `a_ahead_after` says which has the smaller error for more
/// time.
struct Crossover {
  double seconds = 0.0, error = 0.0;
  bool a_ahead_after = false;
};

/// All crossings of the two curves, drawn through the points on log-log axes, inside the times that both cover. Where
/// they only touch there is none; where they part after running on top of each other it is where they met.
std::vector<Crossover> crossovers(std::span<const CostPoint> a, std::span<const CostPoint> b);

}  // namespace sturm
