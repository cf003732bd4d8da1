#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// Another program that is run and waited for.
struct ChildProgram {
  std::vector<std::string> arguments;  ///< the first is its name, looked for in PATH
  std::string cannot_start;            ///< what is said where it is not installed
  std::string failed;                  ///< what is said, before its own complaints, where it ends with an error
};

/// Runs the program with a text as its standard input; returns its standard output. Throws RuntimeFailure where it
/// cannot be started or fails.
std::string output_of(const ChildProgram& program, std::string_view input = "");

}  // namespace sturm
