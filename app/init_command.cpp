#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/starters.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

std::string_view text_of(const std::string& name) {
  for (const auto& [file, text] : embedded_starters())
    if (file == name) return text;
  throw std::logic_error("no starter " + name);
}

/// Nothing that is there is written over.
void require_absent(const fs::path& file) {
  std::error_code code;
  if (fs::exists(file, code)) throw InputError(file.string(), "", "a file that is there already", "another folder");
}

}  // namespace

std::vector<std::string> starter_kinds() {
  std::vector<std::string> kinds;
  for (const auto& [file, text] : embedded_starters())
    if (file.ends_with(".json")) kinds.emplace_back(file.substr(0, file.size() - 5));
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

int init_command(const InitOptions& options) {
  const fs::path folder = options.folder.empty() ? options.kind : options.folder;
  const fs::path document = folder / (options.kind + ".json"), explanation = folder / (options.kind + ".md");
  require_absent(document);
  require_absent(explanation);
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) throw RuntimeFailure(folder.string() + ": " + code.message());
  write_file_atomically(document, text_of(options.kind + ".json"));
  write_file_atomically(explanation, text_of(options.kind + ".md"));
  std::cout << document.string() << "\n" << explanation.string() << "\n";
  return 0;
}

}  // namespace sturm
