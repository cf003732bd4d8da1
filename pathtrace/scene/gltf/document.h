#pragma once
#include <deque>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/json/json.h"

namespace sturm::gltf {

/// A glTF 2.0 file in memory: its JSON document, and the bytes of its buffers. What it claims has been checked, so that
/// whoever reads it may believe that nodes form trees and that buffers, views and accessors lie within the bytes that
/// are there (document_check.h).
class Document {
 public:
  /// .gltf or .glb, told apart by the first bytes. Throws InputError that names file and JSON pointer.
  explicit Document(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  const Json& json() const { return *json_; }
  Source root() const { return {file_.string(), ""}; }

  /// The bytes of a buffer, as many as it states.
  std::span<const unsigned char> buffer(std::size_t index) const { return buffers_[index]; }

  /// The bytes of a buffer view.
  std::span<const unsigned char> view(std::size_t index) const;

 private:
  void read_glb();
  void load_buffers();

  std::filesystem::path file_;
  std::shared_ptr<const Json> json_;
  std::string binary_chunk_;
  std::deque<std::string> stored_;
  std::vector<std::span<const unsigned char>> buffers_;
};

}  // namespace sturm::gltf
