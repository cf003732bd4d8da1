#pragma once
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "io/images/image.h"
#include "stages/page/scene_arrays.h"

namespace sturm {

/// The pictures of a viewer's scene, each once. No value is changed: a picture with few different values is written as
/// numbers into a table of them.
class SceneTextures {
 public:
  explicit SceneTextures(SceneArrays& arrays) : arrays_(arrays) {}

  /// The number of a picture; null where there is none.
  Json number_of(const std::shared_ptr<const Image>& picture);

  /// All of them, in the order of their numbers.
  const Json& list() const { return list_; }

 private:
  SceneArrays& arrays_;
  std::map<const Image*, std::size_t> numbers_;
  Json list_ = Json::array();
};

}  // namespace sturm
