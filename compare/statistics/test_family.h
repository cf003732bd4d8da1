#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace sturm {

/// A family of tests that are looked at together. Tests are registered as they are made; the level of each single one
/// then follows from their number, so that the chance of any false alarm in the whole family is `level` however many
/// tests there are (Šidák; conservative for tests that depend on each other positively).
class TestFamily {
 public:
  /// `level` in (0, 1): the family-wise false-alarm rate. Throws std::domain_error outside.
  explicit TestFamily(double level);

  /// Registers a test by its z-score (a normal deviate; other statistics through their p-value).
  void add(std::string name, double z);

  double level() const { return level_; }
  std::size_t tests() const { return entries_.size(); }

  /// Level of each single test; that of the family as long as there is only one.
  double single_level() const;

  /// z above which a one-sided test is significant, and |z| above which a two-sided one is.
  double one_sided_threshold() const;
  double two_sided_threshold() const;

  /// Names of the tests with |z| above the two-sided threshold, in the order of registration.
  std::vector<std::string> significant() const;

 private:
  struct Entry {
    std::string name;
    double z;
  };
  double level_;
  std::vector<Entry> entries_;
};

}  // namespace sturm
