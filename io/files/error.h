#pragma once
#include <memory>
#include <stdexcept>
#include <string>

namespace sturm {

/// The user's input is wrong (exit status 2). The message names the file, the JSON pointer, the value and what was
/// expected; parts that do not apply are left empty.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, const std::string& pointer, const std::string& value,
             const std::string& expected);  ///< "" where a part does not apply

  // The parts as they were given; the message shortens long ones.
  const std::string& file() const { return parts_->file; }        ///< path of the document, or where else it comes from
  const std::string& pointer() const { return parts_->pointer; }  ///< JSON pointer, or the name of an option
  const std::string& value() const { return parts_->value; }      ///< what stands there
  const std::string& expected() const { return parts_->expected; }  ///< what should stand there

 private:
  struct Parts {
    std::string file, pointer, value, expected;
  };
  std::shared_ptr<const Parts> parts_;  ///< shared, as a copy of an exception must not throw
};

/// Something failed while the work was being done (exit status 3): an unwritable folder, a full disk, a broken module.
class RuntimeFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sturm
