#include "pathtrace/scene/gltf/document_check.h"

#include <string>

#include "io/files/error.h"
#include "pathtrace/scene/gltf/component_types.h"
#include "pathtrace/scene/gltf/extensions.h"
#include "pathtrace/scene/gltf/members.h"

namespace sturm::gltf {

namespace {

constexpr std::uint64_t most_elements = std::uint64_t{1} << 28;
constexpr std::uint64_t most_zeros = std::uint64_t{1} << 24;  // of an accessor without bytes of its own

[[noreturn]] void fail(const Source& where, const std::string& value, const std::string& expected) {
  throw InputError(where.file, where.pointer, value, expected);
}

void check_version(const Json& gltf, const Source& root) {
  if (!gltf.is_object()) fail(root, "no object", "a glTF document");
  const Json& asset = object(gltf, "asset", root);
  const std::string version = text(asset, "version", root / "asset", "2.0");
  if (!version.starts_with("2.")) fail(root / "asset" / "version", "\"" + version + "\"", "glTF 2.0");
}

void check_nodes(const Json& nodes, const Source& all) {
  std::vector<std::int64_t> parent(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_object()) (all / i).fail(nodes[i], "an object");
    for (const Json& child : list(nodes[i], "children", all / i)) {
      const Source where = all / i / "children";
      if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size())
        where.fail(child, "the number of a node, less than " + std::to_string(nodes.size()));
      std::int64_t& known = parent[child.get<std::size_t>()];
      if (known >= 0) where.fail(child, "a node with one parent (it is a child of node " + std::to_string(known) + ")");
      known = static_cast<std::int64_t>(i);
    }
  }
  // With one parent each, a cycle is a walk upwards that does not end. Nodes marked with an earlier walk are known to
  // end.
  std::vector<std::size_t> walk(nodes.size(), 0);
  constexpr int deepest = 1000;  // nodes are followed by recursion
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    int depth = 0;
    for (std::int64_t at = static_cast<std::int64_t>(i); at >= 0; at = parent[static_cast<std::size_t>(at)], ++depth) {
      if (walk[static_cast<std::size_t>(at)] == i + 1)
        fail(all / static_cast<std::size_t>(at), "a node that is its own ancestor", "nodes that form trees");
      if (depth > deepest) fail(all / i, "more than " + std::to_string(deepest) + " ancestors", "fewer");
      walk[static_cast<std::size_t>(at)] = i + 1;
    }
  }
}

struct View {
  std::uint64_t bytes, stride;
};

std::vector<View> checked_views(const Json& views, const Source& all,
                                const std::vector<std::span<const unsigned char>>& buffers) {
  std::vector<View> checked;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Source where = all / i;
    const std::uint64_t buffer = number(views[i], "buffer", where);
    if (buffer >= buffers.size()) fail(where / "buffer", std::to_string(buffer), "the number of a buffer");
    const std::uint64_t offset = number(views[i], "byteOffset", where, 0),
                        length = number(views[i], "byteLength", where), there = buffers[buffer].size();
    if (length > there || offset > there - length)
      fail(where, std::to_string(length) + " bytes at " + std::to_string(offset),
           "a part of the buffer's " + std::to_string(there) + " bytes");
    checked.push_back({length, number(views[i], "byteStride", where, 0)});
  }
  return checked;
}

/// `count` elements of that size from `offset` on lie in the view that `parent` names.
void check_range(const Json& parent, const Source& where, const std::vector<View>& views, std::uint64_t element,
                 std::uint64_t count, const Source& counted) {
  const std::uint64_t view = number(parent, "bufferView", where);
  if (view >= views.size()) fail(where / "bufferView", std::to_string(view), "the number of a buffer view");
  const std::uint64_t offset = number(parent, "byteOffset", where, 0),
                      stride = views[view].stride ? views[view].stride : element;
  if (count == 0) return;
  if (stride < element) fail(where, "a byteStride of " + std::to_string(stride), "one that holds an element");
  if (stride > 255 || offset > views[view].bytes || (count - 1) * stride + element > views[view].bytes - offset)
    fail(counted, std::to_string(count), "as many elements as its buffer view has bytes for");
}

void check_sparse(const Json& accessor, const Source& where, const std::vector<View>& views, std::uint64_t element,
                  std::uint64_t count) {
  const Json& sparse = object(accessor, "sparse", where);
  const Source place = where / "sparse";
  const std::uint64_t changed = number(sparse, "count", place);
  if (changed > count) fail(place / "count", std::to_string(changed), "at most the count of the accessor");
  const Json &indices = object(sparse, "indices", place), &values = object(sparse, "values", place);
  const auto size = bytes_of_component(number(indices, "componentType", place / "indices"));
  if (!size) (place / "indices").fail(indices, "a known \"componentType\"");
  check_range(indices, place / "indices", views, *size, changed, place / "count");
  check_range(values, place / "values", views, element, changed, place / "count");
}

void check_accessors(const Json& accessors, const Source& all, const std::vector<View>& views) {
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    const Json& accessor = accessors[i];
    const Source where = all / i;
    const std::uint64_t count = number(accessor, "count", where);
    const auto component = bytes_of_component(number(accessor, "componentType", where));
    const auto components = components_of_type(text(accessor, "type", where, ""));
    if (!component || !components) where.fail(accessor, "a known \"componentType\" and \"type\"");
    if (count > most_elements) fail(where / "count", std::to_string(count), "at most 2^28");
    const std::uint64_t element = *component * *components;
    if (accessor.contains("bufferView"))
      check_range(accessor, where, views, element, count, where / "count");
    else if (count > most_zeros)
      fail(where / "count", std::to_string(count), "at most 2^24 where there is no buffer view");
    if (accessor.contains("sparse")) check_sparse(accessor, where, views, element, count);
  }
}

void check_images(const Json& images, const Source& all, const std::vector<View>& views) {
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (!images[i].is_object()) (all / i).fail(images[i], "an object");
    if (!images[i].contains("bufferView")) continue;
    const std::uint64_t view = number(images[i], "bufferView", all / i);
    if (view >= views.size()) fail(all / i / "bufferView", std::to_string(view), "the number of a buffer view");
  }
}

}  // namespace

void check_head(const Json& gltf, const Source& root) {
  check_version(gltf, root);
  check_required_extensions(gltf, root);
  check_nodes(list(gltf, "nodes", root), root / "nodes");
}

void check_contents(const Json& gltf, const Source& root, const std::vector<std::span<const unsigned char>>& buffers) {
  const std::vector<View> views = checked_views(list(gltf, "bufferViews", root), root / "bufferViews", buffers);
  check_accessors(list(gltf, "accessors", root), root / "accessors", views);
  check_images(list(gltf, "images", root), root / "images", views);
}

}  // namespace sturm::gltf
