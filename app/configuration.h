#pragma once
#include <filesystem>

#include "app/commands.h"
#include "io/json/json.h"

namespace sturm {

/// Loads the configuration that a command was given and applies --set and --seed to it. It is not validated yet.
Json load_configuration(const CommonOptions& options);

/// Writes a command's result: to `output`, or to standard output where that is empty or "-".
void write_result(const Json& result, const std::string& output);

/// The folder of a file to be written must be there and writable before the work starts, not after it. Throws
/// RuntimeFailure.
void require_writable(const std::filesystem::path& file);

/// Threads that a command will use: as asked for, else one per processor.
int thread_count(const CommonOptions& options);

}  // namespace sturm
