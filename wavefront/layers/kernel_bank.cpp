#include "wavefront/layers/kernel_bank.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "wavefront/layers/detail_share.h"

namespace sturm {

namespace {

constexpr double step_rounding = 1e-9;  // of a step between planes that counts as none

/// All different vergences if they are few.
std::vector<double> few_different(std::span<const double> vergences_D) {
  std::set<double> different;
  double last = vergences_D[0];
  different.insert(last);
  for (const double v : vergences_D) {
    if (v == last) continue;
    different.insert(last = v);
    if (different.size() > few_planes) return {};
  }
  return {different.begin(), different.end()};
}

bool evenly_spaced(const std::vector<double>& planes) {
  if (planes.size() < 2) return false;
  const double step = (planes.back() - planes.front()) / static_cast<double>(planes.size() - 1);
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (std::abs(planes[i] - planes.front() - step * static_cast<double>(i)) > step_rounding * step) return false;
  return true;
}

}  // namespace

std::vector<double> planes_for(std::span<const double> vergences_D, double reach_px_per_D, double spacing_px) {
  if (vergences_D.empty()) throw std::invalid_argument("a picture without pixels has no planes");
  if (std::vector<double> few = few_different(vergences_D); !few.empty()) return few;
  const auto [least, largest] = std::minmax_element(vergences_D.begin(), vergences_D.end());
  const double steps = std::max(1.0, std::ceil((*largest - *least) * reach_px_per_D / spacing_px));
  if (!(steps < most_planes))
    throw std::invalid_argument("the blur changes by " + std::to_string(std::llround(steps)) +
                                " pixels over the picture's depth, more than " + std::to_string(most_planes));
  std::vector<double> planes;
  for (int i = 0; i <= static_cast<int>(steps); ++i) planes.push_back(*least + (*largest - *least) / steps * i);
  return planes;
}

KernelBank::KernelBank(const KernelModel& model, std::vector<double> planes_D)
    : planes_D_(std::move(planes_D)),
      parts_(model.parts),
      channels_(model.channels),
      reach_px_per_D_(model.reach_px_per_D),
      point_kernel_(model.point_kernel),
      rays_(model.rays),
      kernels_(planes_D_.size() * parts_.size() * static_cast<std::size_t>(channels_)),
      radii_(planes_D_.size(), 0),
      detail_shares_(planes_D_.size() * static_cast<std::size_t>(channels_)),
      uniform_(evenly_spaced(planes_D_)) {
  tbb::parallel_for(std::size_t{0}, kernels_.size(), [&](std::size_t i) {
    const auto channel = static_cast<int>(i % channels_), part = static_cast<int>(i / channels_ % parts_.size());
    kernels_[i] = model.kernel(planes_D_[i / channels_ / parts_.size()], part, channel);
  });
  for (std::size_t i = 0; i < kernels_.size(); ++i) {
    int& radius = radii_[i / channels_ / parts_.size()];
    radius = std::max(radius, kernels_[i].radius_px);
  }
  tbb::parallel_for(std::size_t{0}, detail_shares_.size(), [&](std::size_t i) {
    std::vector<WeightedKernel> of_parts;
    for (std::size_t part = 0; part < parts_.size(); ++part)
      of_parts.push_back(
          {&kernel(static_cast<int>(i / channels_), static_cast<int>(part), static_cast<int>(i % channels_)),
           parts_[part].weight});
    detail_shares_[i] = detail_share_of(of_parts);
  });
}

int KernelBank::largest_radius_px() const {
  return *std::max_element(radii_.begin(), radii_.end());
}

int KernelBank::radius_at(double vergence_D) const {
  const Place place = place_of(vergence_D);
  return place.next_weight > 0.0f ? std::max(radii_[place.plane], radii_[place.plane + 1]) : radii_[place.plane];
}

KernelBank::Place KernelBank::place_of(double v) const {
  const int last = static_cast<int>(planes_D_.size()) - 1;
  if (v <= planes_D_.front()) return {0, 0.0f};
  if (v >= planes_D_.back()) return {last, 0.0f};
  int below;
  if (uniform_) {
    const double at = (v - planes_D_.front()) / (planes_D_.back() - planes_D_.front()) * last;
    below = std::min(static_cast<int>(at), last - 1);
    return {below, static_cast<float>(std::clamp(at - below, 0.0, 1.0))};
  }
  below = static_cast<int>(std::upper_bound(planes_D_.begin(), planes_D_.end(), v) - planes_D_.begin()) - 1;
  const double low = planes_D_[static_cast<std::size_t>(below)], high = planes_D_[static_cast<std::size_t>(below) + 1];
  return {below, static_cast<float>((v - low) / (high - low))};
}

}  // namespace sturm
