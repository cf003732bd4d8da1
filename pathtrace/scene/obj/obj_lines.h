#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace sturm {

/// The lines of an OBJ or MTL file, however they end (LF, CR LF, CR). A byte order mark is passed over, and UTF-16
/// becomes UTF-8. A backslash at the end of a line takes the next one in, with a blank between them;
/// comments do not go on.
class ObjLines {
 public:
  /// Throws InputError where the file cannot be read.
  explicit ObjLines(const std::filesystem::path& file);

  /// Goes to the next line that holds more than blanks and comments; false where there is none.
  bool next();

  /// Without blanks at both ends; valid until the next call of `next`.
  std::string_view text() const { return text_; }
  /// Where the line starts, from 1.
  long number() const { return number_; }
  /// "FILE:LINE" of a line of this file.
  std::string place(long line) const { return file_.string() + ":" + std::to_string(line); }
  std::string place() const { return place(number_); }

 private:
  std::string_view take_line();

  std::filesystem::path file_;
  std::string bytes_;
  std::string joined_;
  std::string_view rest_, text_;
  long number_ = 0, taken_ = 0;
};

}  // namespace sturm
