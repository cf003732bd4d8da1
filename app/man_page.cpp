#include "app/man_page.h"

#include <algorithm>
#include <cctype>

namespace sturm {

namespace {

/// Plain text as roff takes it: a hyphen that is one, no request at the start of a line.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
      result += std::string("\\&") + c;
    else
      result += c;
  }
  return result;
}

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string option_entry(const OptionHelp& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "\\fB" : ", \\fB") + roff(name) + "\\fR";
  if (!option.value.empty() && !option.positional) names += " \\fI" + roff(option.value) + "\\fR";
  std::string words;
  for (const std::string& word : option.words) words += (words.empty() ? "" : ", ") + roff(word);
  return ".TP\n" + names + "\n" + roff(option.text) + (words.empty() ? "" : ". One of: " + words) + ".\n";
}

std::string options_section(const CommandHelp& command, bool positional) {
  std::string text;
  for (const OptionHelp& option : command.options)
    if (option.positional == positional) text += option_entry(option);
  return text.empty() ? "" : (positional ? ".SH ARGUMENTS\n" : ".SH OPTIONS\n") + text;
}

/// What stands below the options; its heading is the page's own.
std::string example_section(const std::string& footer) {
  if (footer.empty()) return "";
  return ".SH EXAMPLES\n.nf\n" + roff(footer.substr(footer.find('\n') + 1)) + "\n.fi\n";
}

std::string exit_status_section() {
  return ".SH EXIT STATUS\n"
         ".TP\n\\fB0\\fR\neverything passed\n"
         ".TP\n\\fB1\\fR\na gate, a comparison or a requirement failed\n"
         ".TP\n\\fB2\\fR\nthe input is wrong, the command line included\n"
         ".TP\n\\fB3\\fR\nsomething failed at run time\n";
}

}  // namespace

std::string man_page(const CommandHelp& program, const CommandHelp* command, const std::string& version) {
  const std::string page = command ? program.name + "-" + command->name : program.name;
  std::string text = ".TH " + in_capitals(roff(page)) + " 1 \"\" \"sturm " + roff(version) + "\" \"Sturm\"\n";
  text += ".SH NAME\n" + roff(page) + " \\- " + roff(command ? command->text : program.text) + "\n";
  text += ".SH SYNOPSIS\n\\fB" + roff(program.name) + (command ? " " + roff(command->name) : "") + "\\fR " +
          (command ? "[OPTIONS]" : "\\fICOMMAND\\fR [OPTIONS]");
  if (command)
    for (const OptionHelp& option : command->options)
      if (option.positional) text += " [\\fI" + roff(in_capitals(option.names[0])) + "\\fR]";
  text += "\n";
  const CommandHelp& shown = command ? *command : program;
  if (!command) {
    text += ".SH COMMANDS\n";
    for (const CommandHelp& c : program.commands)
      text += ".TP\n\\fBsturm\\-" + roff(c.name) + "\\fR(1)\n" + roff(c.text) + "\n";
  }
  return text + options_section(shown, true) + options_section(shown, false) + example_section(shown.footer) +
         exit_status_section();
}

}  // namespace sturm
