#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/images/image.h"
#include "io/specs/scene_spec.h"

namespace sturm {

/// Pictures of textures, each read once.
class TextureFiles {
 public:
  /// Three channels, linear; a grey picture becomes RGB. Throws InputError.
  std::shared_ptr<const Image> colours(const std::filesystem::path& file, TextureEncoding encoding);

  /// One channel of a picture as it is stored: 'r', 'g', 'b', 'm' (alpha) or 'l' (luminance); 0: alpha where the
  /// picture has one, else luminance. Throws InputError.
  std::shared_ptr<const Image> channel(const std::filesystem::path& file, char name);

  /// What was chosen or converted on reading.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::map<std::pair<std::filesystem::path, TextureEncoding>, std::shared_ptr<const Image>> colours_;
  std::map<std::pair<std::filesystem::path, char>, std::shared_ptr<const Image>> channels_;
  std::vector<std::string> notes_;
};

}  // namespace sturm
