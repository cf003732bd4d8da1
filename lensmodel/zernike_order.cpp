#include "lensmodel/zernike_order.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace sturm {

namespace {

constexpr int most_polynomials = 231;  // order 20

ZernikeIndex noll_index(int number) {
  int n = 0;
  while ((n + 1) * (n + 2) / 2 < number) ++n;
  const int place = number - n * (n + 1) / 2;  // 1 … n + 1 within the order
  const int frequency = n % 2 == 0 ? 2 * (place / 2) : 2 * ((place - 1) / 2) + 1;
  return {n, number % 2 == 0 ? frequency : -frequency};
}

/// Groups g = (n + |m|)/2 end with the number (g + 1)²; within one, |m| falls from g on, cosine before sine.
ZernikeIndex fringe_index(int number) {
  if (number == 37) return {12, 0};
  int group = 0;
  while ((group + 1) * (group + 1) < number) ++group;
  const int place = number - group * group - 1;  // 0 … 2g
  const int frequency = group - place / 2;
  return {2 * group - frequency, place % 2 == 0 ? frequency : -frequency};
}

}  // namespace

int first_number(ZernikeOrder order) {
  return order == ZernikeOrder::Osa ? 0 : 1;
}

int last_number(ZernikeOrder order) {
  return order == ZernikeOrder::Fringe ? 37 : most_polynomials - 1 + first_number(order);
}

ZernikeIndex zernike_index(ZernikeOrder order, int number) {
  if (number < first_number(order) || number > last_number(order))
    throw std::invalid_argument("no polynomial has the number " + std::to_string(number) + " in this order");
  switch (order) {
    case ZernikeOrder::Osa:
      return ZernikeIndex::of(number);
    case ZernikeOrder::Noll:
      return noll_index(number);
    default:
      return fringe_index(number);
  }
}

bool usually_normalised(ZernikeOrder order) {
  return order != ZernikeOrder::Fringe;
}

double unnormalised_deviation(const ZernikeIndex& index) {
  return 1.0 / std::sqrt((index.m == 0 ? 1.0 : 2.0) * (index.n + 1));
}

std::vector<double> osa_coefficients(std::span<const double> given, ZernikeOrder order, bool normalised) {
  std::vector<double> osa;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const ZernikeIndex index = zernike_index(order, first_number(order) + static_cast<int>(i));
    const auto j = static_cast<std::size_t>(index.single());
    if (osa.size() <= j) osa.resize(j + 1, 0.0);
    osa[j] = normalised ? given[i] : given[i] * unnormalised_deviation(index);
  }
  while (osa.size() > 1 && osa.back() == 0.0) osa.pop_back();
  return osa;
}

std::vector<double> mirrored(std::span<const double> osa) {
  std::vector<double> result(osa.begin(), osa.end());
  for (std::size_t j = 0; j < result.size(); ++j)
    if (changes_sign_mirrored(ZernikeIndex::of(static_cast<int>(j)).m)) result[j] = -result[j];
  return result;
}

}  // namespace sturm
