#pragma once
#include <algorithm>
#include <vector>

namespace sturm {

/// Choice among n things in proportion to their weights, in constant time (Walker 1977, Vose 1991).
class AliasTable {
 public:
  AliasTable() = default;

  /// Weights ≥ 0; if all are 0, all are equal.
  explicit AliasTable(const std::vector<double>& weights)
      : slots_(weights.size(), {1.0f, 0}), probability_(weights.size()) {
    const int n = size();
    double total = 0.0;
    for (double w : weights) total += w;
    std::vector<double> scaled(weights.size());
    std::vector<int> small, large;
    for (int i = 0; i < n; ++i) {
      const double probability = total > 0.0 ? weights[i] / total : 1.0 / n;
      probability_[i] = static_cast<float>(probability);
      scaled[i] = probability * n;
      slots_[i].alias = i;
      (scaled[i] < 1.0 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
      const int s = small.back(), l = large.back();
      small.pop_back();
      slots_[s] = {static_cast<float>(scaled[s]), l};
      scaled[l] -= 1.0 - scaled[s];
      if (scaled[l] < 1.0) {
        large.pop_back();
        small.push_back(l);
      }
    }
  }

  int size() const { return static_cast<int>(slots_.size()); }
  float probability(int i) const { return probability_[static_cast<std::size_t>(i)]; }

  /// Index for the uniform number u in [0, 1); what is left of u after the choice is uniform again and replaces it.
  int choose(float& u) const {
    const float position = u * static_cast<float>(slots_.size());
    const int slot = std::min(static_cast<int>(position), size() - 1);
    const float rest = position - static_cast<float>(slot);
    const Slot& choice = slots_[static_cast<std::size_t>(slot)];
    if (rest < choice.keep) {
      u = rest / choice.keep;
      return slot;
    }
    u = (rest - choice.keep) / (1.0f - choice.keep);
    return choice.alias;
  }

 private:
  struct Slot {
    float keep;  // probability of staying in this slot
    int alias;
  };
  std::vector<Slot> slots_;
  std::vector<float> probability_;
};

}  // namespace sturm
