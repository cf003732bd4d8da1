#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sturm {

/// Finds the files that a model file names, as programs of several systems write their names.
class NamedFiles {
 public:
  struct Found {
    std::filesystem::path file;
    bool elsewhere = false;  ///< its folder is not the one that is named
  };

  /// `folders` are looked through in their order.
  explicit NamedFiles(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

  /// A file of this name: as it is written; then, if it is no UTF-8, as the
  /// Latin-1 that it may be; each first by the letter and then with letters in another case; then, without the folders
  /// that it names, beside the model. Quotes about the name are taken off, and backslashes separate folders. Throws
  /// InputError where the sandbox forbids it (io/files/sandbox.h).
  std::optional<Found> find(std::string_view name) const;

  /// Where the name leads to if it is taken by the letter.
  std::filesystem::path expected(std::string_view name) const;

 private:
  std::optional<std::filesystem::path> in_folders(const std::filesystem::path& name) const;
  std::filesystem::path allowed(const std::filesystem::path& file) const;

  std::vector<std::filesystem::path> folders_;
};

}  // namespace sturm
