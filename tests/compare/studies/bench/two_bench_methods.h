#pragma once
#include <cstdint>
#include <string>
#include <tuple>

#include "compare/studies/bench/measured_view.h"

namespace sturm::test {

inline BenchSample sample(double seconds, double samples, double squared) {
  return {seconds, samples, {squared, squared, squared, squared}};
}

/// Errors 1/√N and half of it, the second method twice as slow per sample.
inline MeasuredView two_methods() {
  MeasuredView view{"v", {}, {}};
  for (const auto& [method, factor, pace] : {std::tuple{"a", 1.0, 1.0}, std::tuple{"b", 0.25, 2.0}})
    for (const int n : {4, 16, 64})
      view.settings.push_back({method,
                               static_cast<std::uint64_t>(n),
                               {sample(pace * n, n, 0.9 * factor / n), sample(3.0 * pace * n, n, 1.1 * factor / n),
                                sample(pace * n, n, factor / n)},
                               n == 4 ? "" : "passes " + std::to_string(n)});
  return view;
}

}  // namespace sturm::test
