#pragma once
#include <string>

namespace sturm {

/// Lines that show what a command does, below "Examples:", as its help and its manual page end. Every command has some;
/// throws std::out_of_range for a name that is no command.
std::string command_examples(const std::string& command);

}  // namespace sturm
