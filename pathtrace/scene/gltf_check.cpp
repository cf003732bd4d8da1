#include "pathtrace/scene/gltf_check.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/files/error.h"
#include "io/json/json.h"

namespace sturm {
namespace {

constexpr std::uint64_t most_elements = std::uint64_t{1} << 28;  // of an accessor without bytes of its own

/// The JSON text of the file and the length of a GLB's binary chunk.
struct Container {
  Json document;
  std::optional<std::uint64_t> binary_bytes;
};

std::uint32_t little_endian(const std::array<unsigned char, 4>& b) {
  return b[0] | b[1] << 8 | b[2] << 16 | static_cast<std::uint32_t>(b[3]) << 24;
}

class GltfCheck {
 public:
  explicit GltfCheck(const std::filesystem::path& file) : file_(file) {}

  void run() {
    const Container container = file_.extension() == ".gltf" ? Container{load_json(file_.string()), {}} : read_glb();
    const Json& gltf = container.document;
    if (!gltf.is_object()) fail("", "no object", "a glTF document");
    check_extensions(gltf);
    check_nodes(list(gltf, "nodes"));
    check_buffers(list(gltf, "buffers"), container.binary_bytes);
    check_views(list(gltf, "bufferViews"));
    check_accessors(list(gltf, "accessors"));
    check_images(list(gltf, "images"));
  }

 private:
  [[noreturn]] void fail(const std::string& pointer, const std::string& value, const std::string& expected) const {
    throw InputError(file_.string(), pointer, value, expected);
  }

  Container read_glb() const {
    const std::uint64_t size = std::filesystem::file_size(file_);
    std::ifstream stream(file_, std::ios::binary);
    const auto word = [&] {
      std::array<unsigned char, 4> bytes{};
      stream.read(reinterpret_cast<char*>(bytes.data()), 4);
      if (!stream)
        fail("", "a file of " + std::to_string(size) + " bytes", "a GLB file with a header and a JSON chunk");
      return little_endian(bytes);
    };
    if (word() != 0x46546C67u) fail("", "another first word", "a GLB file (\"glTF\")");
    if (const std::uint32_t version = word(); version != 2) fail("", "version " + std::to_string(version), "glTF 2.0");
    if (const std::uint32_t length = word(); length > size)
      fail("", "a header that claims " + std::to_string(length) + " bytes",
           "at most the " + std::to_string(size) + " bytes of the file");
    const std::uint32_t json_length = word();
    if (word() != 0x4E4F534Au) fail("", "another first chunk", "a JSON chunk first");
    if (json_length > size - 20)
      fail("", "a JSON chunk of " + std::to_string(json_length) + " bytes", "a chunk that fits into the file");
    std::string text(json_length, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(json_length));
    Container container{parse_json(text, file_.string()), {}};
    const std::uint64_t rest = size - 20 - json_length;
    if (rest < 8) return container;
    const std::uint32_t binary = word();
    word();
    if (binary > rest - 8)
      fail("", "a binary chunk of " + std::to_string(binary) + " bytes", "a chunk that fits into the file");
    container.binary_bytes = binary;
    return container;
  }

  const Json& list(const Json& gltf, const char* key) const {
    static const Json nothing = Json::array();
    const auto at = gltf.find(key);
    if (at == gltf.end()) return nothing;
    if (!at->is_array()) fail(std::string("/") + key, compact(*at), "a list");
    return *at;
  }

  /// A member that is a whole number ≥ 0, or `otherwise`.
  std::uint64_t number(const Json& object, const char* key, const std::string& pointer,
                       std::optional<std::uint64_t> otherwise) const {
    const auto at = object.is_object() ? object.find(key) : object.end();
    if (!object.is_object() || (at == object.end() && !otherwise))
      fail(pointer, compact(object), std::string("an object with \"") + key + "\"");
    if (at == object.end()) return *otherwise;
    if (!at->is_number_unsigned()) fail(pointer + "/" + key, compact(*at), "a whole number of at least 0");
    return at->get<std::uint64_t>();
  }

  void check_extensions(const Json& gltf) const {
    for (const Json& name : list(gltf, "extensionsRequired"))
      if (!name.is_string() || !name.get<std::string>().starts_with("KHR_materials_"))
        fail("/extensionsRequired", compact(name), "a file that needs no extension but KHR_materials_…");
  }

  void check_nodes(const Json& nodes) const {
    std::vector<std::int64_t> parent(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::string pointer = "/nodes/" + std::to_string(i);
      if (!nodes[i].is_object()) fail(pointer, compact(nodes[i]), "an object");
      for (const Json& child : list(nodes[i], "children")) {
        if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size())
          fail(pointer + "/children", compact(child),
               "the number of a node, less than " + std::to_string(nodes.size()));
        std::int64_t& known = parent[child.get<std::size_t>()];
        if (known >= 0)
          fail(pointer + "/children", compact(child),
               "a node with one parent (it is a child of node " + std::to_string(known) + ")");
        known = static_cast<std::int64_t>(i);
      }
    }
    // With one parent each, a cycle is a walk upwards that does not end. Nodes marked with an earlier walk are known to
    // end.
    std::vector<std::size_t> walk(nodes.size(), 0);
    constexpr int deepest = 1000;  // Assimp follows nodes by recursion
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      int depth = 0;
      for (std::int64_t at = static_cast<std::int64_t>(i); at >= 0;
           at = parent[static_cast<std::size_t>(at)], ++depth) {
        if (walk[static_cast<std::size_t>(at)] == i + 1)
          fail("/nodes/" + std::to_string(at), "a node that is its own ancestor", "nodes that form trees");
        if (depth > deepest)
          fail("/nodes/" + std::to_string(i), "more than " + std::to_string(deepest) + " ancestors", "fewer");
        walk[static_cast<std::size_t>(at)] = i + 1;
      }
    }
  }

  void check_buffers(const Json& buffers, std::optional<std::uint64_t> binary_bytes) {
    for (std::size_t i = 0; i < buffers.size(); ++i) {
      const std::string pointer = "/buffers/" + std::to_string(i);
      const std::uint64_t claimed = number(buffers[i], "byteLength", pointer, std::nullopt);
      const auto uri = buffers[i].find("uri");
      std::uint64_t there = 0;
      if (uri == buffers[i].end()) {
        there = i == 0 ? binary_bytes.value_or(0) : 0;
      } else if (!uri->is_string()) {
        fail(pointer + "/uri", compact(*uri), "a text");
      } else if (const std::string text = uri->get<std::string>(); text.starts_with("data:")) {
        there = text.size() / 4 * 3 + 3;  // base64: 4 letters for 3 bytes
      } else {
        const auto path = file_.parent_path() / text;
        if (!std::filesystem::is_regular_file(path)) fail(pointer + "/uri", path.string(), "a file that exists");
        there = std::filesystem::file_size(path);
      }
      if (claimed > there)
        fail(pointer + "/byteLength", std::to_string(claimed),
             "at most the " + std::to_string(there) + " bytes that are there");
      buffer_bytes_.push_back(claimed);
    }
  }

  void check_views(const Json& views) {
    for (std::size_t i = 0; i < views.size(); ++i) {
      const std::string pointer = "/bufferViews/" + std::to_string(i);
      const std::uint64_t buffer = number(views[i], "buffer", pointer, std::nullopt);
      if (buffer >= buffer_bytes_.size()) fail(pointer + "/buffer", std::to_string(buffer), "the number of a buffer");
      const std::uint64_t offset = number(views[i], "byteOffset", pointer, 0),
                          length = number(views[i], "byteLength", pointer, std::nullopt);
      if (length > buffer_bytes_[buffer] || offset > buffer_bytes_[buffer] - length)
        fail(pointer, std::to_string(length) + " bytes at " + std::to_string(offset),
             "a part of the buffer's " + std::to_string(buffer_bytes_[buffer]) + " bytes");
      views_.push_back({length, number(views[i], "byteStride", pointer, 0)});
    }
  }

  /// Embedded images name a buffer view that is there.
  void check_images(const Json& images) const {
    for (std::size_t i = 0; i < images.size(); ++i) {
      const std::string pointer = "/images/" + std::to_string(i);
      if (!images[i].is_object()) fail(pointer, compact(images[i]), "an object");
      if (!images[i].contains("bufferView")) continue;
      const std::uint64_t view = number(images[i], "bufferView", pointer, std::nullopt);
      if (view >= views_.size()) fail(pointer + "/bufferView", std::to_string(view), "the number of a buffer view");
    }
  }

  void check_accessors(const Json& accessors) const {
    static const std::map<std::uint64_t, std::uint64_t> bytes{{5120, 1}, {5121, 1}, {5122, 2},
                                                              {5123, 2}, {5125, 4}, {5126, 4}};
    static const std::map<std::string, std::uint64_t> components{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                                 {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    for (std::size_t i = 0; i < accessors.size(); ++i) {
      const std::string pointer = "/accessors/" + std::to_string(i);
      const std::uint64_t count = number(accessors[i], "count", pointer, std::nullopt);
      const auto component = bytes.find(number(accessors[i], "componentType", pointer, std::nullopt));
      const auto type = accessors[i].find("type");
      const auto size = type != accessors[i].end() && type->is_string() ? components.find(type->get<std::string>())
                                                                        : components.end();
      if (component == bytes.end() || size == components.end())
        fail(pointer, compact(accessors[i]), "a known \"componentType\" and \"type\"");
      if (count > most_elements) fail(pointer + "/count", std::to_string(count), "at most 2^28");
      if (!accessors[i].contains("bufferView")) continue;
      const std::uint64_t view = number(accessors[i], "bufferView", pointer, std::nullopt);
      if (view >= views_.size()) fail(pointer + "/bufferView", std::to_string(view), "the number of a buffer view");
      const std::uint64_t element = component->second * size->second,
                          offset = number(accessors[i], "byteOffset", pointer, 0);
      const std::uint64_t stride = views_[view].stride ? views_[view].stride : element;
      if (count == 0) continue;
      if (stride > 255 || offset > views_[view].bytes || (count - 1) * stride + element > views_[view].bytes - offset)
        fail(pointer + "/count", std::to_string(count), "as many elements as its buffer view has bytes for");
    }
  }

  struct View {
    std::uint64_t bytes, stride;
  };
  const std::filesystem::path& file_;
  std::vector<std::uint64_t> buffer_bytes_;
  std::vector<View> views_;
};

}  // namespace

void check_gltf(const std::filesystem::path& file) {
  GltfCheck(file).run();
}

}  // namespace sturm
