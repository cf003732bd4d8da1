#include "io/images/disocclusion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "io/images/depth_edges.h"

namespace sturm {
namespace {

struct Guess {
  double vergence_D = 0.0;
  std::array<double, 3> rgb{};
};

class HiddenSurface {
 public:
  HiddenSurface(const Image& radiance, const std::vector<double>& vergence_D, double jump_D,
                std::span<const std::size_t> edges)
      : radiance_(radiance), vergence_(vergence_D), jump_(jump_D), guess_(vergence_D.size(), none), edges_(edges) {}

  void grow(const std::function<double(double)>& reach_px) {
    guesses_.reserve(vergence_.size());  // memory is taken as it is filled, and never moved
    mark_mixed_pixels();
    std::vector<std::size_t> front = first_ring();
    for (std::int32_t ring = 2; !front.empty(); ++ring) front = next_ring(front, ring, reach_px);
  }

  std::vector<HiddenSample> samples() const {
    std::vector<HiddenSample> result;
    result.reserve(guesses_.size());
    for (std::size_t i = 0; i < guess_.size(); ++i) {
      if (guess_[i] == none) continue;
      const auto& rgb = guess(i).rgb;
      result.push_back({x_of(i),
                        y_of(i),
                        guess(i).vergence_D,
                        {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])}});
    }
    return result;
  }

 private:
  int x_of(std::size_t i) const { return static_cast<int>(i % radiance_.width); }
  int y_of(std::size_t i) const { return static_cast<int>(i / radiance_.width); }
  const Guess& guess(std::size_t i) const { return guesses_[static_cast<std::size_t>(guess_[i])]; }

  void keep(std::size_t i, const Guess& guess) {
    guess_[i] = static_cast<std::int32_t>(guesses_.size());
    guesses_.push_back(guess);
  }

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
    for (const std::size_t i : edges_)
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
    for (const std::size_t i : edges_) {
      bool edge = false;
      around(i, 1, [&](std::size_t j) { edge = edge || hides(i, vergence_[j]); });
      if (!edge) continue;
      bool found = false;
      Guess behind = visible_behind(i, true, found);
      if (!found) behind = visible_behind(i, false, found);
      keep(i, behind);
      ring.push_back(i);
    }
    return ring;
  }

  /// Grows by one pixel from guesses of earlier rings only, so the order of visits does not matter.
  std::vector<std::size_t> next_ring(const std::vector<std::size_t>& front, std::int32_t ring,
                                     const std::function<double(double)>& reach_px) {
    std::vector<std::size_t> candidates;
    for (const std::size_t i : front)
      around(i, 1, [&](std::size_t j) {
        if (guess_[j] == none) candidates.push_back(j);
      });
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    std::vector<std::size_t> grown;
    std::vector<Guess> guesses;
    for (const std::size_t i : candidates) {
      Guess sum;
      int count = 0;
      around(i, 1, [&](std::size_t j) {
        if (guess_[j] == none || !hides(i, guess(j).vergence_D)) return;
        sum.vergence_D += guess(j).vergence_D;
        for (int c = 0; c < 3; ++c) sum.rgb[c] += guess(j).rgb[c];
        ++count;
      });
      if (count == 0) continue;
      const Guess mean = divided(sum, count);
      if (ring > reach_px(vergence_[i]) + reach_px(mean.vergence_D) + 1.0) continue;
      guesses.push_back(mean);
      grown.push_back(i);
    }
    for (std::size_t k = 0; k < grown.size(); ++k) keep(grown[k], guesses[k]);
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
  static constexpr std::int32_t none = -1;
  std::vector<std::int32_t> guess_;  // of each pixel, which of the guesses
  std::vector<Guess> guesses_;
  std::span<const std::size_t> edges_;
  std::vector<bool> mixed_;
};

}  // namespace

std::vector<HiddenSample> extrapolate_hidden(const Image& radiance, const std::vector<double>& vergence_D,
                                             double jump_D, const std::function<double(double)>& reach_px) {
  return extrapolate_hidden(radiance, vergence_D, jump_D,
                            depth_edges(vergence_D, radiance.width, radiance.height, jump_D), reach_px);
}

std::vector<HiddenSample> extrapolate_hidden(const Image& radiance, const std::vector<double>& vergence_D,
                                             double jump_D, std::span<const std::size_t> edges,
                                             const std::function<double(double)>& reach_px) {
  HiddenSurface surface(radiance, vergence_D, jump_D, edges);
  surface.grow(reach_px);
  return surface.samples();
}

}  // namespace sturm
