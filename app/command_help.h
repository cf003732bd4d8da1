#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sturm {

/// An option or a positional argument, as `--help` has it.
struct OptionHelp {
  std::vector<std::string> names;    ///< "-o", "--output"; of a positional argument its only name, without dashes
  std::string value;                 ///< what stands behind it, "TEXT"; "" for a flag
  std::string text;                  ///< what it is for
  std::vector<std::string> words;    ///< all values that it may have; empty: any
  std::vector<std::string> shipped;  ///< names of shipped documents that may stand in place of a file
  bool positional = false;
};

/// A command with all that it takes.
struct CommandHelp {
  std::string name, text, footer;
  std::vector<OptionHelp> options;
  std::vector<CommandHelp> commands;
};

/// The name of the validator of an option that takes shipped documents of this folder by their names.
std::string shipped_validator(const std::string& kind);

/// What was defined for the command line, for pages and completions.
CommandHelp command_help(CLI::App& app);

std::vector<std::string> command_names(const CommandHelp& program);

std::vector<std::string> words_between_commas(const std::string& text);

/// All names of the options, without positional arguments.
std::vector<std::string> option_names(const CommandHelp& command);

}  // namespace sturm
