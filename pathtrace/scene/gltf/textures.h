#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "io/specs/scene_spec.h"
#include "pathtrace/scene/gltf/document.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm::gltf {

/// What a texture of a material shows, and where.
struct Texture {
  std::shared_ptr<const Image> colours;  ///< 3 channels, linear
  std::shared_ptr<const Image> alpha;    ///< 1 channel; null where it is 1 everywhere
  TextureMapping mapping;
  std::size_t set = 0;  ///< its texture coordinates are TEXCOORD_set
  bool nearest = false;
};

/// The mean of each channel.
Eigen::Vector3f mean_of(const Image& picture);

/// The textures of a file, each picture read once: samplers, KHR_texture_transform, files and embedded pictures.
class Textures {
 public:
  Textures(const Document& document, const ModelSpec& spec) : document_(document), spec_(spec) {}

  /// The texture that the member `key` of a material (or a part of it) names, if it is there. `material` is for
  /// messages about its picture. Throws InputError.
  std::optional<Texture> read(const Json& parent, const char* key, const Source& where, TextureEncoding encoding,
                              const std::string& material);

 private:
  struct Picture {
    std::shared_ptr<const Image> colours, alpha;
  };
  const Picture& picture(std::size_t image, TextureEncoding encoding, const std::string& material);
  Image stored_picture(std::size_t image, const std::string& material) const;
  std::size_t image_of(const Json& texture, const Source& where) const;
  void apply_sampler(const Json& texture, const Source& where, Texture& result) const;

  const Document& document_;
  const ModelSpec& spec_;
  std::map<std::pair<std::size_t, TextureEncoding>, Picture> pictures_;
};

}  // namespace sturm::gltf
