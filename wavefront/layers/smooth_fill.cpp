#include "wavefront/layers/smooth_fill.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sturm {

namespace {

using Rgb = std::array<float, 3>;

constexpr int sweeps = 24;
constexpr float over_relaxation = 1.8f;  // of bands some twenty pixels wide

class Membrane {
 public:
  Membrane(const LayeredPicture& picture, const std::vector<HiddenPixel>& guesses)
      : picture_(picture),
        guesses_(guesses),
        width_(picture.radiance.width),
        height_(picture.radiance.height),
        guess_at_(picture.vergence_D.size(), -1) {
    for (std::size_t i = 0; i < guesses.size(); ++i)
      guess_at_[index(guesses[i].x, guesses[i].y)] = static_cast<std::int32_t>(i);
    nodes_.reserve(guesses.size());
    for (const HiddenPixel& guess : guesses) nodes_.push_back(node_of(guess));
  }

  void relax() {
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t k = 0; k < nodes_.size(); ++k) relax(nodes_[sweep % 2 ? nodes_.size() - 1 - k : k]);
  }

  Rgb color(std::size_t i) const { return nodes_[i].color; }

 private:
  struct Node {
    Rgb color, seen{};  // seen: sum of neighbours whose colours are known
    std::array<std::int32_t, 4> guessed{-1, -1, -1, -1};
    int neighbours = 0;
  };

  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  bool same(double a, double b) const { return std::abs(a - b) <= picture_.jump_D; }

  template <class Visit>
  void around(int x, int y, Visit visit) const {
    for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u) visit(u, v);
  }

  bool mixed(int x, int y) const {
    bool nearer = false;
    const double here = picture_.vergence_D[index(x, y)];
    around(x, y, [&](int u, int v) { nearer |= picture_.vergence_D[index(u, v)] - here > picture_.jump_D; });
    return nearer;
  }

  /// Adds the colour of a seen pixel, or that of its unmixed neighbours if it is mixed and has some.
  bool add_seen(int x, int y, Rgb& sum) const {
    Rgb own{};
    int count = 0;
    const auto add = [&](int u, int v) {
      for (int c = 0; c < 3; ++c) own[c] += picture_.radiance.at(u, v)[c];
      ++count;
    };
    if (!mixed(x, y))
      add(x, y);
    else
      around(x, y, [&](int u, int v) {
        if (same(picture_.vergence_D[index(u, v)], picture_.vergence_D[index(x, y)]) && !mixed(u, v)) add(u, v);
      });
    for (int c = 0; c < 3 && count > 0; ++c) sum[c] += own[c] / static_cast<float>(count);
    return count > 0;
  }

  Node node_of(const HiddenPixel& guess) const {
    Node node{{guess.rgb[0], guess.rgb[1], guess.rgb[2]}};
    constexpr int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (int i = 0; i < 4; ++i) {
      const int x = guess.x + steps[i][0], y = guess.y + steps[i][1];
      if (!inside(x, y)) continue;
      const std::int32_t other = guess_at_[index(x, y)];
      if (other >= 0 && same(guesses_[static_cast<std::size_t>(other)].vergence_D, guess.vergence_D)) {
        node.guessed[i] = other;
        ++node.neighbours;
      } else if (same(picture_.vergence_D[index(x, y)], guess.vergence_D)) {
        node.neighbours += add_seen(x, y, node.seen);
      }
    }
    return node;
  }

  void relax(Node& node) {
    if (node.neighbours == 0) return;
    Rgb sum = node.seen;
    for (const std::int32_t other : node.guessed)
      if (other >= 0)
        for (int c = 0; c < 3; ++c) sum[c] += nodes_[static_cast<std::size_t>(other)].color[c];
    for (int c = 0; c < 3; ++c)
      node.color[c] += over_relaxation * (sum[c] / static_cast<float>(node.neighbours) - node.color[c]);
  }

  const LayeredPicture& picture_;
  const std::vector<HiddenPixel>& guesses_;
  int width_, height_;
  std::vector<std::int32_t> guess_at_;
  std::vector<Node> nodes_;
};

}  // namespace

void smooth_guesses(const LayeredPicture& picture, std::vector<HiddenPixel>& guesses) {
  Membrane membrane(picture, guesses);
  membrane.relax();
  for (std::size_t i = 0; i < guesses.size(); ++i)
    for (int c = 0; c < 3; ++c) guesses[i].rgb[c] = std::max(0.0f, membrane.color(i)[c]);
}

}  // namespace sturm
