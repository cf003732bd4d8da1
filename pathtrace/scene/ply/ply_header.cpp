#include "pathtrace/scene/ply/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/obj/obj_words.h"

namespace sturm {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{{{"char", PlyType::int8},
                                                                           {"uchar", PlyType::uint8},
                                                                           {"short", PlyType::int16},
                                                                           {"ushort", PlyType::uint16},
                                                                           {"int", PlyType::int32},
                                                                           {"uint", PlyType::uint32},
                                                                           {"float", PlyType::float32},
                                                                           {"double", PlyType::float64},
                                                                           {"int8", PlyType::int8},
                                                                           {"uint8", PlyType::uint8},
                                                                           {"int16", PlyType::int16},
                                                                           {"uint16", PlyType::uint16},
                                                                           {"int32", PlyType::int32},
                                                                           {"uint32", PlyType::uint32},
                                                                           {"float32", PlyType::float32},
                                                                           {"float64", PlyType::float64}}};

constexpr std::array<std::pair<std::string_view, PlyHeader::Encoding>, 3> encodings{
    {{"ascii", PlyHeader::Encoding::text},
     {"binary_little_endian", PlyHeader::Encoding::little_endian},
     {"binary_big_endian", PlyHeader::Encoding::big_endian}}};

template <class Table>
auto found_in(const Table& table, std::string_view name) {
  const auto at = std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.first == name; });
  return at == table.end() ? std::nullopt : std::optional(at->second);
}

class HeaderReader {
 public:
  HeaderReader(const std::filesystem::path& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  PlyHeader run() {
    const std::size_t magic = bytes_.find_first_of("\r\n");
    if (magic == std::string_view::npos || trimmed(bytes_.substr(0, magic)) != "ply")
      throw InputError(place(1), "", in_quotes(bytes_.substr(0, std::min<std::size_t>(magic, 60))), "ply");
    // Behind a lone CR a line may be followed by a byte 10 that is data, so all lines end as the first one does.
    line_end_ = bytes_[magic] == '\n' ? "\n" : bytes_.substr(magic).starts_with("\r\n") ? "\r\n" : "\r";
    bool has_format = false;
    for (take_line(); take_line() != "end_header";) {
      std::string_view rest = line_;
      const std::string_view word = take_word(rest);
      if (word == "format")
        read_format(rest), has_format = true;
      else if (word == "element")
        read_element(rest);
      else if (word == "property")
        read_property(rest);
      else if (word == "comment")
        read_comment(rest);
      else if (!word.empty() && word != "obj_info")
        fail("format, element, property, comment, obj_info or end_header");
    }
    if (!has_format) fail("a line with the format before the end of the header");
    header_.bytes = at_;
    require_room();
    return std::move(header_);
  }

 private:
  std::string place(long line) const { return file_.string() + ":" + std::to_string(line); }

  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError(place(header_.lines), "", in_quotes(line_), expected);
  }

  std::string_view take_line() {
    const std::size_t end = bytes_.find(line_end_, at_);
    if (end == std::string_view::npos)
      throw InputError(file_.string(), "", "no end_header", "a PLY file with a whole header");
    line_ = trimmed(bytes_.substr(at_, end - at_));
    at_ = end + line_end_.size();
    ++header_.lines;
    return line_;
  }

  void read_format(std::string_view rest) {
    const auto encoding = found_in(encodings, take_word(rest));
    if (!encoding || take_word(rest) != "1.0" || !trimmed(rest).empty())
      fail("format ascii 1.0, binary_little_endian 1.0 or binary_big_endian 1.0");
    header_.encoding = *encoding;
  }

  void read_element(std::string_view rest) {
    const std::string_view name = take_word(rest), count = take_word(rest);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), number);
    if (name.empty() || count.empty() || error != std::errc() || end != count.data() + count.size() ||
        !trimmed(rest).empty())
      fail("an element with its name and number");
    for (const PlyElement& known : header_.elements)
      if (known.name == name) fail("every element once");
    if (header_.elements.size() == most) fail("at most " + std::to_string(most) + " elements");
    header_.elements.push_back({std::string(name), number, {}});
  }

  PlyType type(std::string_view name) const {
    const auto known = found_in(type_names, name);
    if (!known) fail("a type: char, uchar, short, ushort, int, uint, float, double or int8 to float64");
    return *known;
  }

  void read_property(std::string_view rest) {
    if (header_.elements.empty()) fail("an element before its properties");
    PlyElement& element = header_.elements.back();
    PlyProperty property;
    const std::string_view word = take_word(rest);
    if (word == "list") {
      property.count = type(take_word(rest));
      if (!is_whole(*property.count)) fail("a list whose length is a whole number");
    }
    property.type = type(word == "list" ? take_word(rest) : word);
    property.name = take_word(rest);
    if (property.name.empty() || !trimmed(rest).empty()) fail("a property with its type and one name");
    for (const PlyProperty& known : element.properties)
      if (known.name == property.name) fail("every property of an element once");
    if (element.properties.size() == most) fail("at most " + std::to_string(most) + " properties of an element");
    element.properties.push_back(std::move(property));
  }

  void read_comment(std::string_view rest) {
    if (lower_case(take_word(rest)) == "texturefile" && !trimmed(rest).empty())
      header_.textures.emplace_back(trimmed(rest));
  }

  /// So that nobody makes room for elements that cannot be there.
  void require_room() const {
    std::size_t left = bytes_.size() - at_ + 1;  // the last blank of a text may be missing
    for (const PlyElement& element : header_.elements) {
      const std::size_t least = element.least_bytes(header_.encoding == PlyHeader::Encoding::text);
      if (least > 0 && element.count > left / least)
        throw InputError(file_.string(), "element " + in_quotes(element.name), std::to_string(element.count),
                         "no more than the rest of the file has room for, which is " + std::to_string(left / least));
      left -= least * element.count;
    }
  }

  static constexpr std::size_t most = 1000;  // since every name is held against all before it

  const std::filesystem::path& file_;
  std::string_view bytes_, line_end_, line_;
  std::size_t at_ = 0;
  PlyHeader header_;
};

}  // namespace

std::size_t bytes_of(PlyType type) {
  constexpr std::array<std::size_t, 8> bytes{1, 1, 2, 2, 4, 4, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

std::size_t PlyElement::least_bytes(bool as_text) const {
  std::size_t sum = 0;
  for (const PlyProperty& property : properties) sum += as_text ? 2 : bytes_of(property.count.value_or(property.type));
  return sum;
}

PlyHeader read_ply_header(const std::filesystem::path& file, std::string_view bytes) {
  return HeaderReader(file, bytes).run();
}

}  // namespace sturm
