#include "app/command_help.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "io/files/shipped_files.h"
#include "io/json/named_file.h"

namespace sturm {

namespace {

/// The words of a type name like "TEXT:{right,left}".
std::vector<std::string> words_of(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos || close < open) return {};
  return words_between_commas(type.substr(open + 1, close - open - 1));
}

/// Names of all documents that the option may be given by name.
std::vector<std::string> shipped_for(CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& kind : shipped_kinds()) {
    try {
      option.get_validator(shipped_validator(kind));
    } catch (const CLI::OptionNotFound&) {
      continue;
    }
    const std::vector<std::string> some = shipped_names(kind);
    names.insert(names.end(), some.begin(), some.end());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

OptionHelp option_help(CLI::Option& option) {
  OptionHelp help;
  const std::string type = option.get_type_name();
  help.text = option.get_description();
  help.positional = option.get_positional();
  help.words = words_of(type);
  help.shipped = shipped_for(option);
  if (option.get_items_expected_max() > 0) help.value = type.substr(0, type.find(':'));
  if (help.positional) {
    help.names = {option.get_single_name()};
    return help;
  }
  for (const std::string& name : option.get_snames()) help.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) help.names.push_back("--" + name);
  return help;
}

}  // namespace

std::string shipped_validator(const std::string& kind) {
  return "shipped:" + kind;
}

CommandHelp command_help(CLI::App& app) {
  CommandHelp help{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
  for (CLI::Option* option : app.get_options({})) help.options.push_back(option_help(*option));
  for (CLI::App* command : app.get_subcommands({})) help.commands.push_back(command_help(*command));
  return help;
}

std::vector<std::string> command_names(const CommandHelp& program) {
  std::vector<std::string> names;
  for (const CommandHelp& command : program.commands) names.push_back(command.name);
  return names;
}

std::vector<std::string> words_between_commas(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream list(text);
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words;
}

std::vector<std::string> option_names(const CommandHelp& command) {
  std::vector<std::string> names;
  for (const OptionHelp& option : command.options)
    if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

}  // namespace sturm
