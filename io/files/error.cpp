#include "io/files/error.h"

#include "io/files/readable_text.h"

namespace sturm {

namespace {

// A name in a file can be as long as the file.
constexpr std::size_t longest_value = 200, longest_place = 400, longest_expectation = 2000;

std::string message(const std::string& file, const std::string& pointer, const std::string& value,
                    const std::string& expected) {
  std::string text = readable(file);
  if (!pointer.empty()) text += (text.empty() ? "" : ": ") + readable(pointer, longest_place);
  if (!value.empty()) text += (text.empty() ? "got " : ": got ") + readable(value, longest_value);
  if (!expected.empty())
    text += (value.empty() ? ": expected " : ", expected ") + readable(expected, longest_expectation);
  return text;
}
}  // namespace

InputError::InputError(const std::string& file, const std::string& pointer, const std::string& value,
                       const std::string& expected)
    : std::runtime_error(message(file, pointer, value, expected)),
      parts_(std::make_shared<const Parts>(Parts{file, pointer, value, expected})) {}

}  // namespace sturm
