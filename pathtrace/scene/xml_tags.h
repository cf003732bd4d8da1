#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace sturm {

/// The tags of an XML text, one after the other; comments are passed over. Entities stay as they are.
class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : text_(text) {}

  /// Goes to the next tag; false where there is none.
  bool next();

  /// "node" of <node id="a">, "/node" of </node>.
  std::string_view name() const { return tag_.substr(0, tag_.find_first_of(" \t\r\n/>", 1)); }
  /// The value of an attribute, or "".
  std::string attribute(std::string_view name) const;
  /// <node/>
  bool closes_itself() const { return tag_.ends_with('/'); }

  /// Where the tag starts, and where what follows it does.
  std::size_t begin() const { return begin_; }
  std::size_t end() const { return end_; }
  /// The text between this tag and the next.
  std::string_view content() const { return text_.substr(end_, text_.find('<', end_) - end_); }

 private:
  std::string_view text_, tag_;  // the tag without its brackets
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace sturm
