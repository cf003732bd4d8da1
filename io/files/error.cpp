#include "io/files/error.h"

namespace sturm {

namespace {
std::string message(const std::string& file, const std::string& pointer, const std::string& value,
                    const std::string& expected) {
  std::string text = file;
  if (!pointer.empty()) text += (text.empty() ? "" : ": ") + pointer;
  if (!value.empty()) text += (text.empty() ? "got " : ": got ") + value;
  if (!expected.empty()) text += (value.empty() ? ": expected " : ", expected ") + expected;
  return text;
}
}  // namespace

InputError::InputError(const std::string& file, const std::string& pointer, const std::string& value,
                       const std::string& expected)
    : std::runtime_error(message(file, pointer, value, expected)) {}

}  // namespace sturm
