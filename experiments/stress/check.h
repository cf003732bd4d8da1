#pragma once
#include <array>
#include <cmath>
#include <cstdint>

namespace sturm::stress {

enum class Check : std::uint8_t {
  status,
  finite,
  correction,
  exit_point,
  exit_direction,
  footprint,
  curvature,
  symplectic,
  split,
  turned,
  scaled,
  mirrored,
  transposed,
  five_variables,
  accommodation,
  infinity,
  prism
};
inline constexpr std::size_t check_count = 17;

struct CheckInfo {
  const char *name, *meaning;
};
inline constexpr std::array<CheckInfo, check_count> checks{{
    {"status", "what became of the chief ray, against the oracle"},
    {"finite", "no number is NaN or infinite, nothing throws"},
    {"correction", "power at the cornea, and the naked eye's footprint, against extended precision"},
    {"exit_point", "where the chief ray meets back and front, against the oracle"},
    {"exit_direction", "direction of the chief ray before the lens, against the oracle"},
    {"footprint", "ray transfer and X(d)/d, against the oracle's derivatives"},
    {"curvature", "curvature of the wave at the exit point, against the oracle"},
    {"symplectic", "the 4x4 ray transfer from air to air"},
    {"split", "every transfer in two pieces"},
    {"turned", "eye and lens turned about the primary line of sight"},
    {"scaled", "all lengths times k, powers divided by k"},
    {"mirrored", "x turned to -x"},
    {"transposed", "plus and minus form of the prescription"},
    {"five_variables", "matrix form against the scalar one"},
    {"accommodation", "linear in A; the best A has the least major axis"},
    {"infinity", "the limit 1/d to 0"},
    {"prism", "deviation on the axis of a lens that was made with a prism, by the oracle"},
}};

/// Why a check did not run.
enum class Skip : std::uint8_t {
  none,
  not_applicable,  ///< no spectacles, a prescription that is refused, or a lens without prism
  lost,            ///< the chief ray is lost, and the oracle agrees
  at_the_edge,     ///< rounding decides what becomes of the ray
  focal_line       ///< a focal line lies where the quantity has a pole
};
inline constexpr std::array<const char*, 5> skips{"none", "not_applicable", "lost", "at_the_edge", "focal_line"};

/// Error of one check in one case. `ratio` = error over bound: more than 1 is a defect of the program, or of the error
/// model.
struct Outcome {
  bool ran = false;
  Skip skip = Skip::not_applicable;
  double ratio = 0.0;
  double relative = 0.0;  ///< error over the size of the quantity
};

/// What the checks say about one case.
class Outcomes {
 public:
  /// Keeps the worst. A number that is not one counts as infinitely wrong.
  void record(Check check, double error, double bound, double size) {
    Outcome& o = at(check);
    o.ran = true;
    o.skip = Skip::none;
    const auto kept = [](double old, double x) { return std::isnan(x) ? HUGE_VAL : std::fmax(old, x); };
    o.ratio = kept(o.ratio, error == 0.0 ? 0.0 : error / bound);
    o.relative = kept(o.relative, error == 0.0 ? 0.0 : error / size);
  }
  void expect(Check check, bool holds) { record(check, holds ? 0.0 : HUGE_VAL, 1.0, 1.0); }
  void skip(Check check, Skip why) {
    if (!at(check).ran) at(check).skip = why;
  }
  /// All that were to follow the chief ray through the lens.
  void skip_rest(Skip why) {
    for (Outcome& o : outcomes_)
      if (&o != &at(Check::prism) && !o.ran && o.skip == Skip::not_applicable) o.skip = why;
  }
  const Outcome& operator[](Check check) const { return outcomes_[static_cast<std::size_t>(check)]; }
  const std::array<Outcome, check_count>& all() const { return outcomes_; }
  bool passed() const {
    for (const Outcome& o : outcomes_)
      if (o.ratio > 1.0) return false;
    return true;
  }

 private:
  Outcome& at(Check check) { return outcomes_[static_cast<std::size_t>(check)]; }
  std::array<Outcome, check_count> outcomes_;
};

}  // namespace sturm::stress
