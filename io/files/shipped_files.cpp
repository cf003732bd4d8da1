#include "io/files/shipped_files.h"

#include <algorithm>
#include <cstdlib>

namespace sturm {

namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".json";

bool is_folder(const fs::path& path) {
  std::error_code code;
  return fs::is_directory(path, code);
}

std::optional<fs::path> first_file(const fs::path& below) {
  std::error_code code;
  for (const fs::path& folder : shipped_folders())
    if (fs::is_regular_file(folder / below, code)) return (folder / below).lexically_normal();
  return std::nullopt;
}

}  // namespace

std::vector<fs::path> shipped_folders() {
  std::vector<fs::path> candidates;
  if (const char* named = std::getenv("STURM_DATA"); named && *named) candidates.emplace_back(named);
  std::error_code code;
  const fs::path bin = fs::read_symlink("/proc/self/exe", code).parent_path();
  candidates.push_back(bin / "../share/sturm/configs");
  candidates.push_back(bin / "../../../configs");  // build/PRESET/bin
  std::vector<fs::path> folders;
  for (const fs::path& candidate : candidates)
    if (is_folder(candidate / "scenes")) folders.push_back(fs::absolute(candidate).lexically_normal());
  return folders;
}

std::optional<fs::path> shipped_document(const std::string& kind, const std::string& name) {
  if (name.empty() || name.find_first_of("/.") != std::string::npos) return std::nullopt;
  return first_file(fs::path(kind) / (name + ending));
}

std::vector<std::string> shipped_names(const std::string& kind) {
  std::vector<std::string> names;
  std::error_code code;
  for (const fs::path& folder : shipped_folders())
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / kind, code))
      if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::optional<fs::path> shipped_counterpart(const fs::path& path) {
  const fs::path folder = path.parent_path().filename();
  if (folder.empty() || folder == "." || folder == ".." || path.is_absolute()) return std::nullopt;
  return first_file(folder / path.filename());
}

}  // namespace sturm
