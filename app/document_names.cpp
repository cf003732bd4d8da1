#include "app/document_names.h"

#include <algorithm>
#include <filesystem>

namespace sturm {

namespace {

/// The last folders of a file and its name.
std::string with_folders(const std::string& file, int folders) {
  std::filesystem::path name = document_name(file), folder = std::filesystem::path(file).parent_path();
  for (int i = 0; i < folders && folder.has_filename(); ++i, folder = folder.parent_path())
    name = folder.filename() / name;
  return name.string();
}

}  // namespace

std::string document_name(const std::string& file) {
  return file == "-" ? "standard input" : std::filesystem::path(file).stem().string();
}

std::vector<std::string> document_names(const std::vector<std::string>& files) {
  constexpr int most_folders = 8;
  std::vector<std::string> names;
  for (const std::string& file : files) {
    const auto is_shared = [&](int folders) {
      return std::any_of(files.begin(), files.end(), [&](const std::string& other) {
        return other != file && with_folders(other, folders) == with_folders(file, folders);
      });
    };
    int folders = 0;
    while (folders < most_folders && is_shared(folders)) ++folders;
    names.push_back(folders < most_folders ? with_folders(file, folders) : file);
  }
  return names;
}

}  // namespace sturm
