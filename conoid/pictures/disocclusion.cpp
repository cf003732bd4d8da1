#include "conoid/pictures/disocclusion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sturm {
namespace {

struct Guess {
  double vergence_D = 0.0;
  std::array<double, 3> rgb{};
};

class HiddenSurface {
 public:
  HiddenSurface(const Image& radiance, const std::vector<double>& vergence_D, double jump_D)
      : radiance_(radiance),
        vergence_(vergence_D),
        jump_(jump_D),
        guesses_(vergence_D.size()),
        ring_(vergence_D.size(), 0) {}

  void grow(const std::function<double(double)>& reach_px) {
    mark_mixed_pixels();
    std::vector<std::size_t> front = first_ring();
    for (std::int32_t ring = 2; !front.empty(); ++ring) front = next_ring(front, ring, reach_px);
  }

  std::vector<HiddenSample> samples() const {
    std::vector<HiddenSample> result;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (ring_[i] <= 0) continue;
      const auto& rgb = guesses_[i].rgb;
      result.push_back({x_of(i),
                        y_of(i),
                        guesses_[i].vergence_D,
                        {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])}});
    }
    return result;
  }

 private:
  int x_of(std::size_t i) const { return static_cast<int>(i % radiance_.width); }
  int y_of(std::size_t i) const { return static_cast<int>(i / radiance_.width); }
  bool hides(std::size_t i, double far_vergence) const { return vergence_[i] - far_vergence > jump_; }

  template <class Visit>
  void around(std::size_t i, int distance, Visit visit) const {
    const int x = x_of(i), y = y_of(i);
    for (int v = std::max(0, y - distance); v <= std::min(radiance_.height - 1, y + distance); ++v)
      for (int u = std::max(0, x - distance); u <= std::min(radiance_.width - 1, x + distance); ++u)
        if (u != x || v != y) visit(static_cast<std::size_t>(v) * radiance_.width + u);
  }

  /// A far pixel beside an edge may hold some of the near surface's light (pixels are box filtered): not a source of
  /// colour if avoidable.
  void mark_mixed_pixels() {
    mixed_.assign(vergence_.size(), false);
    for (std::size_t i = 0; i < vergence_.size(); ++i)
      around(i, 1, [&](std::size_t j) {
        if (hides(j, vergence_[i])) mixed_[i] = true;
      });
  }

  /// Mean of the pixels around i that lie behind it, of the nearest surface among them.
  Guess visible_behind(std::size_t i, bool unmixed_only, bool& found) const {
    double nearest = -1.0;
    const auto usable = [&](std::size_t j) { return hides(i, vergence_[j]) && !(unmixed_only && mixed_[j]); };
    around(i, 2, [&](std::size_t j) {
      if (usable(j)) nearest = std::max(nearest, vergence_[j]);
    });
    Guess sum;
    int count = 0;
    around(i, 2, [&](std::size_t j) {
      if (!usable(j) || nearest - vergence_[j] > jump_) return;
      sum.vergence_D += vergence_[j];
      for (int c = 0; c < 3; ++c) sum.rgb[c] += radiance_.at(x_of(j), y_of(j))[c];
      ++count;
    });
    found = count > 0;
    return found ? divided(sum, count) : sum;
  }

  std::vector<std::size_t> first_ring() {
    std::vector<std::size_t> ring;
    for (std::size_t i = 0; i < vergence_.size(); ++i) {
      bool edge = false;
      around(i, 1, [&](std::size_t j) { edge = edge || hides(i, vergence_[j]); });
      if (!edge) continue;
      bool found = false;
      guesses_[i] = visible_behind(i, true, found);
      if (!found) guesses_[i] = visible_behind(i, false, found);
      ring.push_back(i);
    }
    for (const std::size_t i : ring) ring_[i] = 1;
    return ring;
  }

  /// Grows by one pixel from guesses of earlier rings only, so the order of visits does not matter.
  std::vector<std::size_t> next_ring(const std::vector<std::size_t>& front, std::int32_t ring,
                                     const std::function<double(double)>& reach_px) {
    std::vector<std::size_t> candidates;
    for (const std::size_t i : front)
      around(i, 1, [&](std::size_t j) {
        if (ring_[j] == 0) candidates.push_back(j);
      });
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    std::vector<std::size_t> grown;
    for (const std::size_t i : candidates) {
      Guess sum;
      int count = 0;
      around(i, 1, [&](std::size_t j) {
        if (ring_[j] == 0 || !hides(i, guesses_[j].vergence_D)) return;
        sum.vergence_D += guesses_[j].vergence_D;
        for (int c = 0; c < 3; ++c) sum.rgb[c] += guesses_[j].rgb[c];
        ++count;
      });
      if (count == 0) continue;
      const Guess guess = divided(sum, count);
      if (ring > reach_px(vergence_[i]) + reach_px(guess.vergence_D) + 1.0) continue;
      guesses_[i] = guess;
      grown.push_back(i);
    }
    for (const std::size_t i : grown) ring_[i] = ring;
    return grown;
  }

  static Guess divided(Guess sum, int count) {
    sum.vergence_D /= count;
    for (double& c : sum.rgb) c /= count;
    return sum;
  }

  const Image& radiance_;
  const std::vector<double>& vergence_;
  double jump_;
  std::vector<Guess> guesses_;
  std::vector<std::int32_t> ring_;  // 0 = nothing hidden is known here
  std::vector<bool> mixed_;
};

}  // namespace

std::vector<HiddenSample> extrapolate_hidden(const Image& radiance, const std::vector<double>& vergence_D,
                                             double jump_D, const std::function<double(double)>& reach_px) {
  HiddenSurface surface(radiance, vergence_D, jump_D);
  surface.grow(reach_px);
  return surface.samples();
}

}  // namespace sturm
