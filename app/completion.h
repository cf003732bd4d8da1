#pragma once
#include <string>
#include <vector>

#include "app/command_help.h"

namespace sturm {

/// The shells that completions are written for.
const std::vector<std::string>& completion_shells();

/// A script for one of them that completes commands, options and the words that options may have, and else files.
std::string completion_script(const CommandHelp& program, const std::string& shell);

}  // namespace sturm
