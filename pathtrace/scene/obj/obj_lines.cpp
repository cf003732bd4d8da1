#include "pathtrace/scene/obj/obj_lines.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/files/error.h"
#include "io/files/text_encoding.h"
#include "io/files/text_file.h"
#include "pathtrace/scene/obj/obj_words.h"

namespace sturm {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::optional<std::string> bytes = file_contents(file);
  if (!bytes) throw InputError(file.string(), "", "", "a file that can be read");
  return *std::move(bytes);
}

}  // namespace

ObjLines::ObjLines(const std::filesystem::path& file)
    : file_(file), bytes_(bytewise_text(bytes_of(file))), rest_(bytes_) {}

std::string_view ObjLines::take_line() {
  std::size_t end = 0;
  while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
  const std::size_t behind = std::min(rest_.size(), end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1));
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(behind);
  ++taken_;
  return line;
}

bool ObjLines::next() {
  while (!rest_.empty()) {
    text_ = trimmed(take_line());
    number_ = taken_;
    if (text_.empty() || text_.front() == '#') continue;
    if (text_.back() != '\\') return true;
    joined_.clear();
    while (!text_.empty() && text_.back() == '\\') {
      joined_.append(text_.substr(0, text_.size() - 1)) += ' ';
      text_ = rest_.empty() ? std::string_view() : trimmed(take_line());
    }
    joined_.append(text_);
    text_ = trimmed(joined_);
    if (!text_.empty()) return true;
  }
  return false;
}

}  // namespace sturm
