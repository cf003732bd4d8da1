#include "pathtrace/scene/named_files.h"

#include <algorithm>

#include "io/files/error.h"
#include "io/files/sandbox.h"
#include "io/files/text_encoding.h"
#include "pathtrace/scene/obj/obj_words.h"

namespace sturm {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

fs::path path_of(std::string_view name) {
  name = trimmed(name);
  if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = trimmed(name.substr(1, name.size() - 2));
  std::string slashes(name);
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  return slashes;
}

/// The path below a folder with whatever case its letters have there; the first in the order of names.
std::optional<fs::path> in_any_case(const fs::path& folder, const fs::path& name) {
  fs::path at = folder;
  for (const fs::path& part : name) {
    std::error_code ignored;
    if (fs::exists(at / part, ignored)) {
      at /= part;
      continue;
    }
    std::optional<fs::path> alike;
    for (fs::directory_iterator entry(at, ignored), end; !ignored && entry != end; entry.increment(ignored))
      if (const fs::path& path = entry->path(); lower_case(path.filename().string()) == lower_case(part.string()))
        if (!alike || path < *alike) alike = path;
    if (!alike) return std::nullopt;
    at = *alike;
  }
  return is_file(at) ? std::optional(at) : std::nullopt;
}

}  // namespace

std::optional<fs::path> NamedFiles::in_folders(const fs::path& name) const {
  for (const fs::path& folder : folders_)
    if (is_file(folder / name)) return folder / name;
  if (name.is_absolute()) return std::nullopt;
  for (const fs::path& folder : folders_)
    if (auto found = in_any_case(folder, name)) return found;
  return std::nullopt;
}

std::optional<NamedFiles::Found> NamedFiles::find(std::string_view name) const {
  const fs::path path = path_of(name);
  if (path.empty()) return std::nullopt;
  if (const auto found = in_folders(path)) return Found{allowed(*found)};
  if (!is_utf8(name))
    if (const auto found = in_folders(path_of(utf8_text(std::string(name))))) return Found{allowed(*found)};
  if (path.has_parent_path() && path.has_filename())
    if (const auto found = in_folders(path.filename())) return Found{allowed(*found), true};
  return std::nullopt;
}

fs::path NamedFiles::allowed(const fs::path& file) const {
  for (const fs::path& folder : folders_)
    if (within_sandbox(file, (folder / "model").string())) return file;
  throw InputError(folders_.back().string(), "", file.string(),
                   "with --sandbox files in the folder of the model, or below");
}

fs::path NamedFiles::expected(std::string_view name) const {
  return folders_.front() / path_of(name);
}

}  // namespace sturm
