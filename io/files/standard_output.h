#pragma once

namespace sturm {

/// Makes failures to write errors that can be told: a closed pipe (SIGPIPE) and a limit of file size (SIGXFSZ) do not
/// kill the process any more, and a standard stream that the caller has closed is not taken by the next file that is
/// opened. Call it first.
void prepare_standard_streams();

/// Writes out what has been printed. Throws RuntimeFailure if anything that was printed since the start of the program
/// did not arrive: a full disk, a pipe that nobody reads. Call it last.
void finish_standard_output();

}  // namespace sturm
