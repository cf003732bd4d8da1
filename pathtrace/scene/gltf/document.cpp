#include "pathtrace/scene/gltf/document.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>

#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/json/data_uri.h"
#include "pathtrace/scene/gltf/document_check.h"
#include "pathtrace/scene/gltf/extensions.h"
#include "pathtrace/scene/gltf/members.h"
#include "pathtrace/scene/gltf/uri.h"

namespace sturm::gltf {

namespace {

std::uint32_t little_endian(const std::array<unsigned char, 4>& b) {
  return b[0] | b[1] << 8 | b[2] << 16 | static_cast<std::uint32_t>(b[3]) << 24;
}

/// The first letters of a file, without blanks and a byte-order mark before them.
std::string first_letters(const std::filesystem::path& file) {
  std::string text(16, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.erase(0, 1);
  return text;
}

bool is_glb(const std::filesystem::path& file) {
  const std::string letters = first_letters(file);
  return letters.starts_with("glTF") || (has_suffix(file, ".glb") && !letters.starts_with("{"));
}

std::string bytes_of(const std::filesystem::path& file, std::uint64_t count, const Source& where) {
  std::string bytes(count, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  if (!stream) throw InputError(where.file, where.pointer, file.string(), "a file that can be read");
  return bytes;
}

const std::string& uri_of(const Json& buffer, const Source& where) {
  const Json& uri = buffer["uri"];
  if (!uri.is_string()) (where / "uri").fail(uri, "a text");
  return uri.get_ref<const std::string&>();
}

}  // namespace

Document::Document(const std::filesystem::path& file) : file_(file) {
  if (is_glb(file))
    read_glb();
  else
    json_ = std::make_shared<const Json>(load_json(file.string()));
  check_head(*json_, root());
  load_buffers();
  check_contents(*json_, root(), buffers_);
}

void Document::read_glb() {
  const auto fail = [&](const std::string& value, const std::string& expected) {
    throw InputError(file_.string(), "", value, expected);
  };
  const std::uint64_t size = std::filesystem::file_size(file_);
  std::ifstream stream(file_, std::ios::binary);
  const auto word = [&] {
    std::array<unsigned char, 4> bytes{};
    stream.read(reinterpret_cast<char*>(bytes.data()), 4);
    if (!stream) fail("a file of " + std::to_string(size) + " bytes", "a GLB file with a header and a JSON chunk");
    return little_endian(bytes);
  };
  if (word() != 0x46546C67u) fail("another first word", "a GLB file (\"glTF\")");
  if (const std::uint32_t version = word(); version != 2) fail("version " + std::to_string(version), "glTF 2.0");
  if (const std::uint32_t length = word(); length > size)
    fail("a header that claims " + std::to_string(length) + " bytes",
         "at most the " + std::to_string(size) + " bytes of the file");
  const std::uint32_t json_length = word();
  if (word() != 0x4E4F534Au) fail("another first chunk", "a JSON chunk first");
  if (json_length > size - 20)
    fail("a JSON chunk of " + std::to_string(json_length) + " bytes", "a chunk that fits into the file");
  std::string json(json_length, '\0');
  stream.read(json.data(), static_cast<std::streamsize>(json_length));
  json.resize(json.find_last_not_of('\0') + 1);  // some writers fill up with zeros
  json_ = std::make_shared<const Json>(parse_json(json, file_.string()));
  // The binary chunk comes second; chunks of other types are passed over.
  for (std::uint64_t rest = size - 20 - json_length; rest >= 8;) {
    const std::uint32_t length = word(), type = word();
    if (length > rest - 8)
      fail("a binary chunk of " + std::to_string(length) + " bytes", "a chunk that fits into the file");
    rest -= 8 + std::uint64_t{length};
    if (type != 0x004E4942u) {
      stream.seekg(length, std::ios::cur);
      continue;
    }
    binary_chunk_.resize(length);
    stream.read(binary_chunk_.data(), length);
    return;
  }
}

void Document::load_buffers() {
  const Json& buffers = list(*json_, "buffers", root());
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const Source where = root() / "buffers" / i;
    const std::uint64_t claimed = number(buffers[i], "byteLength", where);
    const auto check = [&](std::uint64_t there) {
      if (claimed > there)
        throw InputError(where.file, where.pointer + "/byteLength", std::to_string(claimed),
                         "at most the " + std::to_string(there) + " bytes that are there");
    };
    const std::string* bytes = &binary_chunk_;
    if (!buffers[i].contains("uri")) {
      refuse_compressed_buffer(buffers[i], where);
      check(i == 0 ? binary_chunk_.size() : 0);
    } else if (const std::string& uri = uri_of(buffers[i], where); auto data = data_of_uri(uri, where / "uri")) {
      bytes = &stored_.emplace_back(std::move(*data));
      check(bytes->size());
    } else {
      const std::filesystem::path beside = file_of_uri(uri, file_, where / "uri");
      check(std::filesystem::file_size(beside));
      bytes = &stored_.emplace_back(bytes_of(beside, claimed, where / "uri"));
    }
    buffers_.emplace_back(reinterpret_cast<const unsigned char*>(bytes->data()), claimed);
  }
}

std::span<const unsigned char> Document::view(std::size_t index) const {
  const Json& view = (*json_)["bufferViews"][index];
  const Source where = root() / "bufferViews" / index;
  return buffer(number(view, "buffer", where))
      .subspan(number(view, "byteOffset", where, 0), number(view, "byteLength", where));
}

}  // namespace sturm::gltf
