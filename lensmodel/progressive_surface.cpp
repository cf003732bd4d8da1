#include "lensmodel/progressive_surface.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace sturm {

namespace {

/// The ninth-degree step from 0 to 1 with four vanishing derivatives at both ends, its integral, and its first two
/// derivatives; 0 ≤ t ≤ 1.
double step(double t) {
  return t * t * t * t * t * (126.0 + t * (-420.0 + t * (540.0 + t * (-315.0 + t * 70.0))));
}
double step_integral(double t) {
  return t * t * t * t * t * t * (21.0 + t * (-60.0 + t * (67.5 + t * (-35.0 + t * 7.0))));
}
double step_first(double t) {
  const double r = t * (1.0 - t);
  return 630.0 * r * r * r * r;
}
double step_second(double t) {
  const double r = t * (1.0 - t);
  return 2520.0 * r * r * r * (1.0 - 2.0 * t);
}

struct Node {
  double at, weight;
};
/// The positive half of Gauss and Legendre's rule with 16 nodes on (−1, 1): exact for the degree 31.
constexpr std::array<Node, 8> sixteen_nodes{{{0.98940093499164994, 0.027152459411754096},
                                             {0.9445750230732326, 0.062253523938647894},
                                             {0.86563120238783176, 0.095158511682492786},
                                             {0.755404408355003, 0.12462897125553388},
                                             {0.61787624440264377, 0.14959598881657674},
                                             {0.45801677765722737, 0.16915651939500254},
                                             {0.28160355077925892, 0.18260341504492358},
                                             {0.095012509837637441, 0.1894506104550685}}};

/// q = c u²/(1 + √(1 − c²u²)) and its derivatives.
struct Section {
  double value, by_u, by_c, by_uu, by_uc, by_cc;
};
std::optional<Section> circular_section(double c, double u) {
  const double square = u * u, p2 = 1.0 - c * c * square;
  if (!(p2 > 0.0)) return std::nullopt;
  const double p = std::sqrt(p2), p3 = p * p2;
  return Section{c * square / (1.0 + p),
                 c * u / p,
                 square / (p * (1.0 + p)),
                 c / p3,
                 u / p3,
                 c * square * square * (1.0 + 2.0 * p) / (p3 * (1.0 + p) * (1.0 + p))};
}

/// w²/(w² + u²) and its derivatives.
struct Fade {
  double value, first, second;
};
Fade fade(double width, double u) {
  const double w2 = width * width, sum = w2 + u * u, ratio = w2 / sum;
  return {ratio, -2.0 * u * ratio / sum, 2.0 * ratio * (3.0 * u * u - w2) / (sum * sum)};
}

/// m/cos ϑ, where m has the derivatives m′, m″ and ϑ turns by (sin ϑ)′ = k, (sin ϑ)″ = k′.
struct Lifted {
  double value, first, second;
};
Lifted over_cosine(double m, double m1, double m2, double sine, double k, double k1) {
  const double w = std::sqrt(1.0 - sine * sine), w3 = w * w * w, turn = sine * k;
  return {m / w, m1 / w + m * turn / w3,
          m2 / w + (2.0 * m1 * turn + m * (k * k + sine * k1)) / w3 + 3.0 * m * turn * turn / (w3 * w * w)};
}

/// A height over (s, u) with its derivatives.
struct Part {
  double value, by_s, by_u, by_ss, by_su, by_uu;
};
/// The circular sections of curvature c(s).
std::optional<Part> circular_sections(const Lifted& c, double u) {
  const auto q = circular_section(c.value, u);
  if (!q) return std::nullopt;
  return Part{q->value,           q->by_c * c.first, q->by_u, q->by_cc * c.first * c.first + q->by_c * c.second,
              q->by_uc * c.first, q->by_uu};
}
Part faded(const Part& p, const Fade& f) {
  return {p.value * f.value,
          p.by_s * f.value,
          p.by_u * f.value + p.value * f.first,
          p.by_ss * f.value,
          p.by_su * f.value + p.by_s * f.first,
          p.by_uu * f.value + 2.0 * p.by_u * f.first + p.value * f.second};
}
Part operator+(const Part& a, const Part& b) {
  return {a.value + b.value, a.by_s + b.by_s, a.by_u + b.by_u, a.by_ss + b.by_ss, a.by_su + b.by_su, a.by_uu + b.by_uu};
}
Part operator-(const Part& a, const Part& b) {
  return {a.value - b.value, a.by_s - b.by_s, a.by_u - b.by_u, a.by_ss - b.by_ss, a.by_su - b.by_su, a.by_uu - b.by_uu};
}

}  // namespace

ProgressiveSurface::ProgressiveSurface(const ProgressiveSurfaceDesign& design)
    : design_(design), start_(-design.corridor_start_m), end_(start_ + design.corridor_length_m) {
  const double excess = design.refractive_index - 1.0;
  if (!(excess > 0.0)) throw std::invalid_argument("a refractive index of 1 has no surface power");
  if (!(design.corridor_length_m > 0.0))
    throw std::invalid_argument("the corridor of a progressive surface needs a length");
  if (design.zone_width_m && !(*design.zone_width_m > 0.0))
    throw std::invalid_argument("the zones of a progressive surface need a width");
  if (!(std::abs(design.near_shift_m) < end_) && design.near_shift_m != 0.0)
    throw std::invalid_argument("the near zone lies too high for its shift");
  const double sine = design.near_shift_m == 0.0 ? 0.0 : design.near_shift_m / end_,
               cosine = std::sqrt(1.0 - sine * sine);
  down_ << sine, -cosine;
  across_ << cosine, sine;
  far_curvature_ = design.far_power_D / excess;
  added_curvature_ = design.addition_D / excess;
  turn_at_vertex_ = turn_from_start(0.0);
  // Heights count from the fitting cross, wherever in the corridor it lies.
  height_at_start_ = 0.0;
  height_at_end_ = height_in_corridor(end_);
  const auto vertex = height_of_umbilic(0.0);
  *height_at_start_ -= *vertex;
  *height_at_end_ -= *vertex;
  if (!std::isfinite(*height_at_end_ + *height_at_start_))
    throw std::invalid_argument(
        "the umbilic of a progressive surface turns by more than a right angle in its corridor");
}

double ProgressiveSurface::turn_from_start(double s) const {
  const double way = s - start_, length = design_.corridor_length_m, t = way / length;
  const double added = t <= 0.0 ? 0.0 : t >= 1.0 ? way - 0.5 * length : length * step_integral(t);
  return far_curvature_ * way + added_curvature_ * added;
}

ProgressiveSurface::Bend ProgressiveSurface::bend_at(double s) const {
  const double length = design_.corridor_length_m, t = (s - start_) / length,
               sine = turn_from_start(s) - turn_at_vertex_;
  if (t <= 0.0) return {far_curvature_, 0.0, 0.0, sine};
  if (t >= 1.0) return {far_curvature_ + added_curvature_, 0.0, 0.0, sine};
  return {far_curvature_ + added_curvature_ * step(t), added_curvature_ * step_first(t) / length,
          added_curvature_ * step_second(t) / (length * length), sine};
}

double ProgressiveSurface::umbilic_power_D(double s) const {
  return (design_.refractive_index - 1.0) * bend_at(s).k;
}

/// ∫ tan ϑ from the corridor's start to a place within it.
double ProgressiveSurface::height_in_corridor(double s) const {
  const double half = 0.5 * (s - start_), middle = 0.5 * (s + start_);
  const auto slope = [&](double at) {
    const double sine = turn_from_start(at) - turn_at_vertex_;
    return sine / std::sqrt(1.0 - sine * sine);
  };
  double sum = 0.0;
  for (const Node& node : sixteen_nodes)
    sum += node.weight * (slope(middle - half * node.at) + slope(middle + half * node.at));
  return half * sum;
}

std::optional<double> ProgressiveSurface::height_of_umbilic(double s) const {
  if (s > start_ && s < end_) return *height_at_start_ + height_in_corridor(s);
  const double from = s <= start_ ? start_ : end_, known = s <= start_ ? *height_at_start_ : *height_at_end_;
  // A circle: from one place to another it rises by the chord's mean slope.
  const double first = turn_from_start(from) - turn_at_vertex_, last = turn_from_start(s) - turn_at_vertex_;
  return known + (s - from) * (first + last) / (std::sqrt(1.0 - first * first) + std::sqrt(1.0 - last * last));
}

std::optional<Sag> ProgressiveSurface::sag(double x, double y) const {
  const double s = down_.x() * x + down_.y() * y, u = across_.x() * x + across_.y() * y;
  const Bend bend = bend_at(s);
  if (!(std::abs(bend.sine) < 1.0)) return std::nullopt;
  const double cosine = std::sqrt(1.0 - bend.sine * bend.sine);
  const auto whole = circular_sections(over_cosine(bend.k, bend.first, bend.second, bend.sine, bend.k, bend.first), u);
  const auto far = circular_sections(over_cosine(far_curvature_, 0.0, 0.0, bend.sine, bend.k, bend.first), u);
  if (!whole || !far) return std::nullopt;
  const Part umbilic{*height_of_umbilic(s), bend.sine / cosine, 0.0, bend.k / (cosine * cosine * cosine), 0.0, 0.0};
  // Circles as they are, and not far + (whole − far), where nothing fades.
  const Part section = design_.zone_width_m ? *far + faded(*whole - *far, fade(*design_.zone_width_m, u)) : *whole;
  const Part z = umbilic + section;
  Sag result;
  result.value = z.value;
  result.gradient = z.by_s * down_ + z.by_u * across_;
  result.hessian = z.by_ss * down_ * down_.transpose() +
                   z.by_su * (down_ * across_.transpose() + across_ * down_.transpose()) +
                   z.by_uu * across_ * across_.transpose();
  return result;
}

}  // namespace sturm
