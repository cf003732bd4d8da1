#pragma once
#include <filesystem>
#include <string>

namespace sturm {

/// The name in messages of what options alone say, without a file. Paths in it start at the working directory.
inline constexpr const char* command_line_source = "command line";

/// From now on files may name only files in their own folder and below it, links followed (`--sandbox`): for documents
/// and models from someone who is not trusted.
void enter_sandbox();

/// Whether enter_sandbox was called.
bool sandbox_is_on();

/// Whether `path`, which `naming_file` names, may be opened: always outside of a sandbox, and always where whoever runs
/// the program has named it (`command_line_source`). Both are paths of the file system; `naming_file` may be "<stdin>",
/// which stands in the working directory.
bool within_sandbox(const std::filesystem::path& path, const std::string& naming_file);

}  // namespace sturm
