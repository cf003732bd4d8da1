#include "stages/page/scene_textures.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace sturm {

namespace {

constexpr std::size_t largest_table = 65536;

/// All different values in order; none where they are more than a table holds.
std::vector<float> different_values(const std::vector<float>& values) {
  std::vector<float> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() > largest_table) sorted.clear();
  return sorted;
}

template <class Number>
std::vector<Number> numbers_in(const std::vector<float>& table, const std::vector<float>& values) {
  std::vector<Number> numbers;
  numbers.reserve(values.size());
  for (const float value : values)
    numbers.push_back(static_cast<Number>(std::lower_bound(table.begin(), table.end(), value) - table.begin()));
  return numbers;
}

}  // namespace

Json SceneTextures::number_of(const std::shared_ptr<const Image>& picture) {
  if (!picture) return nullptr;
  const auto known = numbers_.find(picture.get());
  if (known != numbers_.end()) return known->second;
  const std::vector<float>& values = picture->pixels;
  const std::vector<float> table = different_values(values);
  Json entry = {{"width", picture->width}, {"height", picture->height}, {"channels", picture->channels}};
  if (table.empty())
    entry["texels"] = arrays_.add(values, picture->channels);
  else if (table.size() <= 256)
    entry["texels"] = arrays_.add(numbers_in<std::uint8_t>(table, values), picture->channels);
  else
    entry["texels"] = arrays_.add(numbers_in<std::uint16_t>(table, values), picture->channels);
  entry["table"] = table.empty() ? Json(nullptr) : arrays_.add(table, 1);
  list_.push_back(std::move(entry));
  return numbers_[picture.get()] = list_.size() - 1;
}

}  // namespace sturm
