#include <algorithm>
#include <iostream>

#include "app/command_help.h"
#include "app/command_options.h"
#include "app/completion.h"
#include "app/man_page.h"
#include "app/starters.h"
#include "io/files/atomic_file.h"
#include "io/files/build_info.h"

namespace sturm {

namespace {

/// All pages, as man looks for them.
int write_man_pages(const CommandHelp& program, const std::filesystem::path& folder) {
  const std::string version(build_info().version);
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  write_file_atomically(folder / (program.name + ".1"), man_page(program, nullptr, version));
  for (const CommandHelp& command : program.commands)
    write_file_atomically(folder / (program.name + "-" + command.name + ".1"), man_page(program, &command, version));
  return 0;
}

/// The page of a command, or that of the program where `name` is "".
int print_man_page(const CommandHelp& program, const std::string& name) {
  const auto command = std::find_if(program.commands.begin(), program.commands.end(),
                                    [&](const CommandHelp& one) { return one.name == name; });
  std::cout << man_page(program, command == program.commands.end() ? nullptr : &*command,
                        std::string(build_info().version));
  return 0;
}

}  // namespace

void CommandLine::add_init() {
  auto* i = app.add_subcommand("init", "write a starter that runs, with an explanation of each key beside it");
  i->add_option("kind", init.kind, "what to start")->required()->check(CLI::IsMember(starter_kinds()));
  i->add_option("folder", init.folder, "that it is written into; made if need be (default: the kind)");
  i->callback([this] { action = [this] { return init_command(init); }; });
}

void CommandLine::add_doctor() {
  app.add_subcommand("doctor", "what this installation is and has, and what it lacks")->callback([this] {
    action = [] { return doctor_command(); };
  });
}

void CommandLine::add_completion() {
  auto* c = app.add_subcommand("completion", "print a script that completes commands and options in a shell");
  c->add_option("shell", shell, "which one")->required()->check(CLI::IsMember(completion_shells()));
  c->callback([this] {
    action = [this] {
      std::cout << completion_script(command_help(app), shell);
      return 0;
    };
  });
}

void CommandLine::add_man() {
  auto* m = app.add_subcommand("man", "print a manual page, of a command or of the program, for man -l -");
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  m->add_option("command", shell, "e.g. ellipse")->check(CLI::IsMember(names));
  m->add_option("--folder", folder, "write all pages into this folder instead");
  m->callback([this] {
    action = [this] {
      const CommandHelp program = command_help(app);
      return folder.empty() ? print_man_page(program, shell) : write_man_pages(program, folder);
    };
  });
}

}  // namespace sturm
