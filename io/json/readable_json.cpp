#include "io/json/readable_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/json/json_text.h"

namespace sturm {

namespace {

constexpr std::size_t width = 120;

/// Appends the value without a line break as long as `line` stays within `most` characters; false where it does not.
bool put_on_line(const Json& value, std::size_t most, std::string& line) {
  if (!value.is_structured()) {
    line += json_text(value);
    return line.size() <= most;
  }
  const bool object = value.is_object();
  line += object ? '{' : '[';
  bool first = true;
  for (auto member = value.begin(); member != value.end(); ++member) {
    if (!first) line += ", ";
    first = false;
    if (object) line += json_text(Json(member.key())) + ": ";
    if (!put_on_line(*member, most, line)) return false;
  }
  line += object ? '}' : ']';
  return line.size() <= most;
}

class Page {
 public:
  const std::string& text() const { return text_; }

  void put(const Json& value, std::size_t level) {
    std::string line;
    if (!value.is_structured() || value.empty())
      put_word(json_text(value));
    else if (put_on_line(value, width - std::min(width, column_), line))
      put_word(line);
    else
      put_members(value, level + 1);
  }

 private:
  void put_word(const std::string& word) {
    text_ += word;
    column_ += word.size();
  }

  void new_line(std::size_t level) {
    text_ += '\n' + std::string(level, ' ');
    column_ = level;
  }

  /// As many members on a line as fit; objects, and what needs several lines, have lines of their own.
  void put_members(const Json& value, std::size_t level) {
    put_word(value.is_object() ? "{" : "[");
    bool joins = false;  // the line goes on
    for (auto member = value.begin(); member != value.end(); ++member) {
      if (member != value.begin()) put_word(",");
      const std::string key = value.is_object() ? json_text(Json(member.key())) + ": " : "";
      std::string line = key;
      const bool is_word = put_on_line(*member, width - std::min(width, level), line) && !member->is_object();
      if (joins && is_word && column_ + 1 + line.size() < width)
        put_word(" ");
      else
        new_line(level);
      put_word(key);
      put(*member, level);
      joins = is_word;
    }
    new_line(level - 1);
    put_word(value.is_object() ? "}" : "]");
  }

  std::string text_;
  std::size_t column_ = 0;  ///< characters on the last line
};

}  // namespace

std::string readable_json(const Json& value) {
  Page page;
  page.put(value, 0);
  return page.text();
}

}  // namespace sturm
