#include "pathtrace/scene/xml_tags.h"

#include <algorithm>

namespace sturm {

bool XmlTags::next() {
  for (begin_ = text_.find('<', end_); begin_ != std::string_view::npos; begin_ = text_.find('<', end_)) {
    if (text_.substr(begin_).starts_with("<!--")) {
      end_ = std::min(text_.find("-->", begin_), text_.size());
      continue;
    }
    const std::size_t close = std::min(text_.find('>', begin_), text_.size());
    tag_ = text_.substr(begin_ + 1, close - begin_ - 1);
    end_ = std::min(close + 1, text_.size());
    return true;
  }
  return false;
}

std::string XmlTags::attribute(std::string_view name) const {
  for (std::size_t at = tag_.find(name); at != std::string_view::npos; at = tag_.find(name, at + 1)) {
    const std::size_t equals = tag_.find_first_not_of(" \t\r\n", at + name.size());
    if (at == 0 || std::string_view(" \t\r\n").find(tag_[at - 1]) == std::string_view::npos) continue;
    if (equals == std::string_view::npos || tag_[equals] != '=') continue;
    const std::size_t open = tag_.find_first_of("\"'", equals);
    const std::size_t close = open == std::string_view::npos ? open : tag_.find(tag_[open], open + 1);
    if (close != std::string_view::npos) return std::string(tag_.substr(open + 1, close - open - 1));
  }
  return {};
}

}  // namespace sturm
