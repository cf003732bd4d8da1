#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sturm {

/// Folders that hold the documents shipped with the program, each with `scenes`, `views`, `lenses`, … below it, best
/// first: what the environment variable STURM_DATA names; share/sturm/configs of the installation that the program
/// belongs to; configs of the source tree that it was built in. Only those that exist.
std::vector<std::filesystem::path> shipped_folders();

/// The shipped document `name` of the folder `kind`: ("views", "desk") is views/desk.json. None where there is no such
/// document, and where `name` is no plain name but a path or a file name with an ending.
std::optional<std::filesystem::path> shipped_document(const std::string& kind, const std::string& name);

/// Names of all shipped documents of a folder, sorted.
std::vector<std::string> shipped_names(const std::string& kind);

/// The shipped file that a path means by its last folder and name: "../scenes/desk.json" in a view that was copied away
/// from the shipped scenes.
std::optional<std::filesystem::path> shipped_counterpart(const std::filesystem::path& path);

}  // namespace sturm
