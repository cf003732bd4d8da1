#include "app/completion.h"

#include <functional>

namespace sturm {

namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// The words, or the names of shipped documents, that stand without an option.
std::vector<std::string> positional(const CommandHelp& command, std::vector<std::string> OptionHelp::*member) {
  std::vector<std::string> words;
  for (const OptionHelp& option : command.options)
    if (option.positional) words.insert(words.end(), (option.*member).begin(), (option.*member).end());
  return words;
}

/// Text between single quotes of a shell.
std::string shell_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Calls with each option that may have one of a few words or names: "render|--psf" and the words.
void for_each_choice(const CommandHelp& program,
                     const std::function<void(const CommandHelp&, const OptionHelp&)>& put) {
  for (const CommandHelp& command : program.commands)
    for (const OptionHelp& option : command.options)
      if (!option.positional && !(option.words.empty() && option.shipped.empty())) put(command, option);
}

std::string bash_script(const CommandHelp& program) {
  std::string text =
      "# Completion of sturm for bash.\n"
      "_sturm() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command='' word words='' "
      "shipped='' options='' chosen=''\n"
      "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
      "    case $word in\n"
      "      " +
      joined(command_names(program), "|") +
      ") command=$word; break ;;\n"
      "    esac\n"
      "  done\n"
      "  case \"$command $previous\" in\n";
  for_each_choice(program, [&](const CommandHelp& command, const OptionHelp& option) {
    for (const std::string& name : option.names)
      text += "    \"" + command.name + " " + name + "\") words=\"" + joined(option.words, " ") + "\" shipped=\"" +
              joined(option.shipped, " ") + "\" chosen=1 ;;\n";
  });
  text += "  esac\n  case $command in\n";
  const auto put_words = [&](const std::string& command, const std::vector<std::string>& words,
                             const std::vector<std::string>& shipped, const std::vector<std::string>& options) {
    text += "    " + command + ") options=\"" + joined(options, " ") + "\"";
    if (!words.empty()) text += "; words=${words:-" + joined(words, " ") + "}";
    if (!shipped.empty()) text += "; shipped=${shipped:-" + joined(shipped, " ") + "}";
    text += " ;;\n";
  };
  put_words("\"\"", command_names(program), {}, option_names(program));
  for (const CommandHelp& command : program.commands)
    put_words(command.name, positional(command, &OptionHelp::words), positional(command, &OptionHelp::shipped),
              option_names(command));
  return text +
         "  esac\n"
         "  [[ $current == -* && -z $chosen ]] && words=$options shipped=''\n"
         "  [[ -n $shipped ]] && compopt -o filenames 2>/dev/null\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words $shipped\" -- \"$current\"; [[ -n $shipped ]] && compgen -f "
         "-- "
         "\"$current\")\n"
         "}\n"
         "complete -o default -F _sturm sturm\n";
}

/// What completes a word with a name or a file; in the list of an option no colon may stand.
std::string zsh_names(const std::vector<std::string>& shipped) {
  return shipped.empty() ? "_files" : "{_sturm_names " + joined(shipped, " ") + "}";
}

std::string zsh_values(const OptionHelp& option) {
  return option.words.empty() ? zsh_names(option.shipped) : "(" + joined(option.words, " ") + ")";
}

std::string zsh_option(const OptionHelp& option, const std::string& name) {
  std::string text;
  for (const char c : option.text) text += c == '[' || c == ']' ? ' ' : c;
  const std::string value = option.value.empty() ? "" : ":value:" + zsh_values(option);
  return shell_quoted("*" + name + "[" + text + "]" + value);
}

/// Arguments by their places; the last of them may be repeated.
std::string zsh_positional(const CommandHelp& command) {
  std::vector<const OptionHelp*> arguments;
  for (const OptionHelp& option : command.options)
    if (option.positional) arguments.push_back(&option);
  std::string text;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string place = i + 1 == arguments.size() ? "*" : std::to_string(i + 1);
    text += " \\\n        " + shell_quoted(place + ":" + arguments[i]->names[0] + ":" + zsh_values(*arguments[i]));
  }
  return text;
}

std::string zsh_script(const CommandHelp& program) {
  std::string text =
      "#compdef sturm\n"
      "# Completion of sturm for zsh.\n"
      "_sturm_names() {\n"
      "  _alternative \"names:shipped document:($*)\" 'files:file:_files'\n"
      "}\n"
      "_sturm() {\n"
      "  local -a commands=(\n";
  for (const CommandHelp& command : program.commands)
    text += "    " + shell_quoted(command.name + ":" + command.text) + "\n";
  text +=
      "  )\n"
      "  local -i at=2\n"
      "  while (( at < CURRENT )) && [[ $words[at] == -* ]]; do (( at++ )); done\n"
      "  if (( CURRENT == at )); then\n"
      "    if [[ $words[at] == -* ]]; then compadd -- " +
      joined(option_names(program), " ") +
      "; else _describe command commands; fi\n"
      "    return\n"
      "  fi\n"
      "  shift $(( at - 1 )) words\n"
      "  (( CURRENT -= at - 1 ))\n"
      "  case $words[1] in\n";
  for (const CommandHelp& command : program.commands) {
    text += "    " + command.name + ")\n      _arguments";
    for (const OptionHelp& option : command.options)
      if (!option.positional)
        for (const std::string& name : option.names) text += " \\\n        " + zsh_option(option, name);
    text += zsh_positional(command) + " ;;\n";
  }
  return text +
         "  esac\n"
         "}\n"
         "if [[ $funcstack[1] == _sturm ]]; then\n"
         "  _sturm \"$@\"\n"
         "else\n"
         "  compdef _sturm sturm\n"
         "fi\n";
}

std::string fish_script(const CommandHelp& program) {
  std::string text = "# Completion of sturm for fish.\n";
  for (const CommandHelp& command : program.commands)
    text +=
        "complete -c sturm -n __fish_use_subcommand -f -a " + command.name + " -d " + shell_quoted(command.text) + "\n";
  for (const CommandHelp& command : program.commands)
    for (const OptionHelp& option : command.options) {
      text += "complete -c sturm -n '__fish_seen_subcommand_from " + command.name + "'";
      for (const std::string& name : option.names)
        if (!option.positional) text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.words.empty())
        text += (option.positional ? " -f -a " : " -x -a ") + shell_quoted(joined(option.words, " "));
      else if (!option.value.empty() && !option.positional)
        text += " -r";
      if (!option.shipped.empty()) text += " -a " + shell_quoted(joined(option.shipped, " "));
      text += " -d " + shell_quoted(option.text) + "\n";
    }
  return text;
}

}  // namespace

const std::vector<std::string>& completion_shells() {
  static const std::vector<std::string> shells = {"bash", "zsh", "fish"};
  return shells;
}

std::string completion_script(const CommandHelp& program, const std::string& shell) {
  if (shell == "zsh") return zsh_script(program);
  return shell == "fish" ? fish_script(program) : bash_script(program);
}

}  // namespace sturm
