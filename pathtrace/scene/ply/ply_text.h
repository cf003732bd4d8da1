#pragma once
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/files/error.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/obj/obj_words.h"
#include "pathtrace/scene/ply/ply_header.h"

namespace sturm {

/// The elements of a PLY file that is text: a line for each, with all of its numbers. Blank lines are passed over.
class PlyText {
 public:
  /// `rest`: what follows the header, which had so many lines.
  PlyText(const std::string& file, std::string_view rest, long lines) : file_(file), rest_(rest), line_number_(lines) {}

  /// Goes to the next element. Throws InputError where the file ends, as the others do where a line is wrong.
  void begin() {
    do {
      if (rest_.empty()) throw InputError(file_, "", "an early end", "a line for each element that the header states");
      std::size_t end = 0;
      while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
      line_ = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(end);
      rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
      ++line_number_;
    } while (line_.empty());
    left_ = line_;
  }

  double number(PlyType type) {
    const std::string_view word = take_word(left_);
    if (is_whole(type)) {  // the quick way; else it may still be one, such as +1 or 1.0
      std::int32_t whole = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), whole);
      if (error == std::errc() && end == word.data() + word.size()) return whole;
    }
    const std::optional<double> number = number_of(word);
    if (!number)
      throw InputError(place(), "", in_quotes(word.empty() ? line_ : word),
                       word.empty() ? "a number for each property" : "a number with a decimal point");
    return *number;
  }

  void skip(PlyType type, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) number(type);
  }

  /// Nothing may be left of the element.
  void end() const {
    if (!trimmed(left_).empty())
      throw InputError(place(), "", in_quotes(line_), "no more numbers than the header states properties");
  }

  /// How many numbers the rest of the element can hold at most.
  std::size_t room(PlyType) const { return (left_.size() + 1) / 2; }

  std::string place() const { return file_ + ":" + std::to_string(line_number_); }

 private:
  const std::string& file_;
  std::string_view rest_, line_, left_;
  long line_number_;
};

}  // namespace sturm
