#pragma once
#include <string>

#include "app/command_help.h"

namespace sturm {

/// The page sturm-COMMAND(1) in the language of man, or sturm(1) for the program itself where `command` is null.
std::string man_page(const CommandHelp& program, const CommandHelp* command, const std::string& version);

}  // namespace sturm
