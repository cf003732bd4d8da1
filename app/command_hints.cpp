#include "app/command_hints.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <regex>

#include "io/files/formatted_text.h"
#include "io/json/suggest.h"

namespace sturm {

namespace {

/// The name of the command, as it was given; "" if there is none.
std::string command_in(const std::vector<std::string>& arguments) {
  const auto word = std::find_if(arguments.begin(), arguments.end(), [](const std::string& a) { return a[0] != '-'; });
  return word == arguments.end() ? "" : *word;
}

const CommandHelp* find_command(const CommandHelp& program, const std::string& name) {
  const auto found = std::find_if(program.commands.begin(), program.commands.end(),
                                  [&](const CommandHelp& command) { return command.name == name; });
  return found == program.commands.end() ? nullptr : &*found;
}

bool looks_like_an_option(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' &&
         (argument[1] == '-' || std::isalpha(static_cast<unsigned char>(argument[1])));
}

/// The nearest of the candidates, or the only one that goes on where the word ends.
std::string hint(const std::string& word, const std::vector<std::string>& candidates) {
  if (const std::string near = did_you_mean(word, candidates); !near.empty()) return near;
  const std::string* only = nullptr;
  for (const std::string& candidate : candidates)
    if (candidate.starts_with(word) || word.starts_with(candidate + "-")) {
      if (only) return "";
      only = &candidate;
    }
  return only ? " (did you mean \"" + *only + "\"?)" : "";
}

/// The option or positional argument of this name; none where the command has no such one.
const OptionHelp* find_option(const CommandHelp* command, const std::string& name) {
  if (!command) return nullptr;
  const auto found = std::find_if(command->options.begin(), command->options.end(), [&](const OptionHelp& option) {
    return std::find(option.names.begin(), option.names.end(), name) != option.names.end();
  });
  return found == command->options.end() ? nullptr : &*found;
}

/// " [mm]", as the option's text has it; "" where it has no unit.
std::string unit_of(const OptionHelp* option) {
  if (!option) return "";
  const std::size_t open = option->text.rfind('['), close = option->text.rfind(']');
  return open == std::string::npos || close < open ? "" : " " + option->text.substr(open, close + 1 - open);
}

/// What a number may not have, where this text has it.
std::string flaw_of_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  if (end == text.c_str() || !*end) return "";
  return *end == ',' ? ", with a decimal point" : ", without a unit";
}

/// What stands behind an option, or in the place of an argument.
std::string description_of(const OptionHelp* option) {
  if (!option) return "";
  const std::vector<std::string>& words = option->words.empty() ? option->shipped : option->words;
  return ": " + option->text + (words.empty() ? "" : "; " + one_of(words));
}

/// A number as it is, any other text between quotes.
std::string shown(const std::string& value) {
  char* end = nullptr;
  std::strtod(value.c_str(), &end);
  return end == value.c_str() || *end ? "\"" + value + "\"" : value;
}

}  // namespace

std::string unknown_command(const CommandHelp& program, const std::vector<std::string>& arguments) {
  const std::string name = command_in(arguments);
  if (name.empty() || find_command(program, name)) return "";
  const std::vector<std::string> options = option_names(program);
  const bool is_option = std::find(options.begin(), options.end(), "--" + name) != options.end();
  return "\"" + name + "\" is no command of sturm" +
         (is_option ? " (did you mean \"--" + name + "\"?)" : hint(name, command_names(program))) +
         "; sturm --help lists them all";
}

std::string unknown_option(const CommandHelp& program, const std::vector<std::string>& arguments,
                           const std::vector<std::string>& unexpected) {
  const auto option = std::find_if(unexpected.begin(), unexpected.end(), looks_like_an_option);
  if (option == unexpected.end()) return "";
  const std::string word = option->substr(0, option->find('='));
  const CommandHelp* command = find_command(program, command_in(arguments));
  std::vector<std::string> known = option_names(program);
  if (command) {
    const std::vector<std::string> own = option_names(*command);
    known.insert(known.begin(), own.begin(), own.end());
  }
  const std::string whose = command ? "sturm " + command->name : "sturm";
  return "\"" + word + "\" is no option of " + whose + hint(word, known) + "; " + whose + " --help lists them all";
}

std::string unusable_value(const CommandHelp& program, const std::vector<std::string>& arguments,
                           const std::string& complaint) {
  const std::string line = complaint.substr(0, complaint.find('\n'));
  static const std::regex range(R"((\S+): Value (.+) not in range (\S+) to (\S+))"),
      choice(R"((\S+): (.*) not in \{(.*)\})"), number(R"(Could not convert: (\S+) = (.*))"),
      missing(R"((.+) is required)"), twice(R"((\S+): At Most 1 required but received (\d+))"),
      nothing(R"((\S+): 1 required (\S+) missing)");
  const CommandHelp* command = find_command(program, command_in(arguments));
  std::smatch part;
  std::string said = line;
  if (std::regex_match(line, part, range)) {
    said = part.str(1) + ": got " + shown(part.str(2)) + ", expected a number from " +
           plain_number(std::stod(part[3])) + " to " + plain_number(std::stod(part[4])) +
           unit_of(find_option(command, part[1])) + flaw_of_number(part[2]);
  } else if (std::regex_match(line, part, choice)) {
    const std::vector<std::string> words = words_between_commas(part[3]);
    said = part.str(1) + ": got \"" + part.str(2) + "\"" + did_you_mean(part.str(2), words) + ", expected " +
           one_of(words);
  } else if (std::regex_match(line, part, number)) {
    said = part.str(1) + ": got \"" + part.str(2) + "\", expected a number" + unit_of(find_option(command, part[1])) +
           flaw_of_number(part[2]);
  } else if (std::regex_match(line, part, missing)) {
    said = part.str(1) + " is missing" + description_of(find_option(command, part[1]));
  } else if (std::regex_match(line, part, twice)) {
    said = part.str(1) + ": got " + part.str(2) + " of them, expected one";
  } else if (std::regex_match(line, part, nothing)) {
    said = part.str(1) + ": got nothing behind it, expected " + part.str(2) +
           description_of(find_option(command, part[1]));
  }
  return said + "; sturm" + (command ? " " + command->name : "") + " --help explains";
}

}  // namespace sturm
