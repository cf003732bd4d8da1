#include "app/command_line.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <sstream>

#include "app/command_help.h"
#include "app/command_hints.h"
#include "app/command_options.h"
#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/files/standard_output.h"

namespace sturm {

namespace {

enum ExitStatus { passed = 0, failed = 1, wrong_input = 2, runtime_failure = 3 };

/// One line, or more where the reason has more; names of files need not be text.
void print_error(const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", readable_lines(error.what()).c_str());
}

/// Help goes to standard output. Of what is wrong, a mistyped name explains more than what follows from it.
int answer_parse_error(CLI::App& app, const std::vector<std::string>& arguments, const CLI::ParseError& error) {
  std::ostringstream help, complaint;
  const int code = app.exit(error, help, complaint);
  std::cout << help.str();
  if (code == 0) return passed;
  const CommandHelp program = command_help(app);
  std::string mistake = unknown_command(program, arguments);
  if (mistake.empty()) mistake = unknown_option(program, arguments, app.remaining(true));
  if (mistake.empty()) mistake = unusable_value(program, arguments, complaint.str());
  if (arguments.empty())
    std::cerr << app.help();
  else
    std::cerr << readable_lines("error: " + mistake + "\n");
  return wrong_input;
}

/// `sturm help COMMAND` is `sturm COMMAND --help`.
std::vector<std::string> given_arguments(int argc, char** argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (!arguments.empty() && arguments.front() == "help") {
    arguments.erase(arguments.begin());
    arguments.emplace_back("--help");
  }
  return arguments;
}

int run_action(int argc, char** argv) {
  CommandLine line;
  const std::vector<std::string> arguments = given_arguments(argc, argv);
  try {
    line.app.parse(
        std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // the parser takes them from the back
  } catch (const CLI::ParseError& error) {
    return answer_parse_error(line.app, arguments, error);
  }
  try {
    std::unique_ptr<tbb::global_control> limit;
    if (line.common.threads > 0)
      limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(line.common.threads));
    return line.action();
  } catch (const InputError& error) {
    print_error(error);
    return wrong_input;
  } catch (const std::exception& error) {
    print_error(error);
    return runtime_failure;
  }
}

}  // namespace

int run_command_line(int argc, char** argv) {
  prepare_standard_streams();
  const int status = run_action(argc, argv);
  try {
    finish_standard_output();
  } catch (const RuntimeFailure& error) {
    if (status == passed || status == failed) print_error(error);  // else the reason has been printed
    return status == wrong_input ? wrong_input : runtime_failure;
  }
  return status;
}

}  // namespace sturm
