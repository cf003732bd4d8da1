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
  return "\"" + name + "\" is no command of sturm" + hint(name, command_names(program)) +
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
      missing(R"((.+) is required)");
  std::smatch part;
  std::string said = line;
  if (std::regex_match(line, part, range)) {
    said = part.str(1) + ": got " + shown(part.str(2)) + ", expected a number from " +
           plain_number(std::stod(part[3])) + " to " + plain_number(std::stod(part[4]));
  } else if (std::regex_match(line, part, choice)) {
    const std::vector<std::string> words = words_between_commas(part[3]);
    said = part.str(1) + ": got \"" + part.str(2) + "\"" + did_you_mean(part.str(2), words) + ", expected " +
           one_of(words);
  } else if (std::regex_match(line, part, number)) {
    said = part.str(1) + ": got \"" + part.str(2) + "\", expected a number";
  } else if (std::regex_match(line, part, missing)) {
    said = part.str(1) + " is missing";
  }
  const CommandHelp* command = find_command(program, command_in(arguments));
  return said + "; sturm" + (command ? " " + command->name : "") + " --help explains";
}

}  // namespace sturm
