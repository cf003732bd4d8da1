#include "io/files/child_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>

#include "io/files/error.h"

extern char** environ;

namespace sturm {

namespace {

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

/// A nameless temporary file. Files instead of pipes: neither side can block the other, and a dead child raises no
/// SIGPIPE.
File scratch_file(const std::string& user) {
  File file(std::tmpfile(), &std::fclose);
  if (!file) throw RuntimeFailure("cannot create a temporary file for " + user + ": " + std::strerror(errno));
  fcntl(fileno(file.get()), F_SETFD, FD_CLOEXEC);
  return file;
}

std::string contents(FILE* file) {
  std::string text;
  std::array<char, 65536> block;
  std::rewind(file);
  for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), file)) > 0;) text.append(block.data(), n);
  return text;
}

/// Its process, or the error of the system.
int start(const ChildProgram& program, const File& input, const File& output, const File& complaints, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(output.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(complaints.get()), STDERR_FILENO);
  std::vector<std::string> words = program.arguments;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t fatal;  // what this program ignores ends a child that does not look whether it could write
  sigemptyset(&fatal);
  sigaddset(&fatal, SIGPIPE);
  sigaddset(&fatal, SIGXFSZ);
  posix_spawnattr_setsigdefault(&attributes, &fatal);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  const int failed = posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failed;
}

}  // namespace

std::string output_of(const ChildProgram& program, std::string_view text) {
  const std::string& name = program.arguments.front();
  const File input = scratch_file(name), output = scratch_file(name), complaints = scratch_file(name);
  if (std::fwrite(text.data(), 1, text.size(), input.get()) != text.size() || std::fflush(input.get()) != 0)
    throw RuntimeFailure("cannot write the input of " + name + ": " + std::strerror(errno));
  std::rewind(input.get());
  pid_t child = 0;
  if (const int failed = start(program, input, output, complaints, child); failed != 0)
    throw RuntimeFailure(program.cannot_start + ": " + std::strerror(failed));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw RuntimeFailure("lost the process of " + name + ": " + std::strerror(errno));
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw RuntimeFailure(program.failed + ": " + contents(complaints.get()));
  return contents(output.get());
}

}  // namespace sturm
