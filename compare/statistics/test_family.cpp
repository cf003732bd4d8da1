#include "compare/statistics/test_family.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/statistics/statistics.h"

namespace sturm {

TestFamily::TestFamily(double level) : level_(level) {
  if (!(level > 0.0 && level < 1.0)) throw std::domain_error("a family-wise level lies between 0 and 1");
}

void TestFamily::add(std::string name, double z) {
  entries_.push_back({std::move(name), z});
}

double TestFamily::single_level() const {
  return sidak_level(level_, std::max<std::size_t>(1, entries_.size()));
}

double TestFamily::one_sided_threshold() const {
  return normal_upper_quantile(single_level());
}

double TestFamily::two_sided_threshold() const {
  return normal_upper_quantile(0.5 * single_level());
}

std::vector<std::string> TestFamily::significant() const {
  std::vector<std::string> names;
  for (const Entry& e : entries_)
    if (std::abs(e.z) > two_sided_threshold()) names.push_back(e.name);
  return names;
}

}  // namespace sturm
