#include "io/files/standard_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include "io/files/error.h"

namespace sturm {

namespace {

/// Opens what is closed the other way round, so that using it stays an error.
void occupy(int descriptor, int mode) {
  if (::fcntl(descriptor, F_GETFD) >= 0) return;
  const int file = ::open("/dev/null", mode);
  if (file < 0 || file == descriptor) return;
  ::dup2(file, descriptor);
  ::close(file);
}

}  // namespace

void prepare_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  occupy(STDIN_FILENO, O_WRONLY);
  occupy(STDOUT_FILENO, O_RDONLY);
  occupy(STDERR_FILENO, O_RDONLY);
}

void finish_standard_output() {
  int error = std::fflush(stdout) == 0 ? 0 : errno;
  std::cout.flush();
  const bool failed_before = std::ferror(stdout) || !std::cout.good();
  // The stream does not keep the reason of an earlier failure. A further byte behind what is broken anyway meets it.
  if (failed_before && !error && ::write(STDOUT_FILENO, "\n", 1) < 0) error = errno;
  // Some file systems tell only on closing that there was no room; closing a copy leaves the stream to its owner.
  if (const int copy = ::dup(STDOUT_FILENO); copy >= 0 && ::close(copy) != 0 && !error) error = errno;
  if (!error && !failed_before) return;
  throw RuntimeFailure("standard output: writing failed" +
                       (error ? std::string(": ") + std::strerror(error) : std::string()));
}

}  // namespace sturm
