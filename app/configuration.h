#pragma once
#include <filesystem>

#include "app/commands.h"
#include "io/json/json.h"

namespace sturm {

/// Loads the configuration that a command was given and applies to it what the options say. It is not validated yet,
/// but it is no document of another known kind. `otherwise` stands in place of a file that was not given.
Json load_configuration(const CommonOptions& options, const Json& otherwise = nullptr);

/// Whether the document stands in a file: neither on standard input nor in the command line.
bool is_in_file(const CommonOptions& options);

/// The same options with `command_line_source` in place of a file that was not given. Throws InputError where there is
/// no prescription either.
CommonOptions with_source(const CommonOptions& options);

/// What --print-config does: checks the document and writes it. Returns the exit status.
int print_configuration(const Json& document, const std::string& file, const std::string& output);

/// Writes a command's result: to `output`, or to standard output where that is empty or "-".
void write_result(const Json& result, const std::string& output);
void write_text(const std::string& text, const std::string& output);

/// The folder of a file to be written must be there and writable before the work starts, not after it. Throws
/// RuntimeFailure.
void require_writable(const std::filesystem::path& file);

/// Threads that a command will use: as asked for, else one per processor.
int thread_count(const CommonOptions& options);

}  // namespace sturm
