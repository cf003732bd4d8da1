#pragma once

namespace sturm {

/// Parses the command line, runs the command and returns the exit status: 0 passed, 1 a gate or comparison failed,
/// 2 the input is wrong, 3 a failure at run time.
int run_command_line(int argc, char** argv);

}  // namespace sturm
