#pragma once
#include <string>
#include <vector>

#include "app/command_help.h"

namespace sturm {

/// What is wrong with the name of the command, with what was probably meant; "" where it is known or missing.
std::string unknown_command(const CommandHelp& program, const std::vector<std::string>& arguments);

/// The same for the first of the arguments that nobody expected, where it looks like an option; "" if none does.
std::string unknown_option(const CommandHelp& program, const std::vector<std::string>& arguments,
                           const std::vector<std::string>& unexpected);

/// The parser's complaint about what stands behind an option, or is missing, in the words of other messages.
std::string unusable_value(const CommandHelp& program, const std::vector<std::string>& arguments,
                           const std::string& complaint);

}  // namespace sturm
